import { expect, test } from 'vitest'
import type { Contact } from '../wire/facts'
import { contactsAt } from './contacts'

const scene = { bodies: ['base', 'tool:jaws', 'pallet'].map(name => ({ name })) } as never
const deep: Contact = {
  one: 'tool:jaws',
  other: 'pallet',
  begin: 1,
  end: 2,
  distance: -0.0131,
  time: 1.5,
  place: [0.1, 0.2, 0.3],
  bodies: 'jaws – pallet',
  station: 'robot',
  line: 7,
  visit: 1,
}

test('a contact is shown from its begin to its end, both included', () => {
  const shown = (time: number) => contactsAt([deep], scene, time).length
  expect([0.99, 1, 1.5, 2, 2.01].map(shown)).toEqual([0, 1, 1, 1, 0])
})

test('it has the places of both bodies, its deepest point and words with the depth', () => {
  expect(contactsAt([deep], scene, 1.5)).toEqual([
    { bodies: [1, 2], place: [0.1, 0.2, 0.3], text: 'jaws – pallet, 13.1 mm deep' },
  ])
})

test('a body that the scene no longer has is left out', () => {
  const gone = { ...deep, other: 'crate' }
  expect(contactsAt([gone], scene, 1.5)[0]?.bodies).toEqual([1])
})
