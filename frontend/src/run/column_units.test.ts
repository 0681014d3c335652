import { expect, it } from 'vitest'
import { unitOf, unitsByAxes } from './column_units'

const AXES = [
  { name: '1', type: 'revolute' },
  { name: 'E1', type: 'prismatic' },
] as const

it.each([
  ['rad | m', ['rad', 'm']],
  ['rad | m/s', ['rad/s', 'm/s']],
  ['N·m | N', ['N·m', 'N']],
])('axes that turn and axes that slide have their own: %s', (unit, units) => {
  const channel = { unit, columns: ['1', 'E1'] }
  const told = { ...channel, units: unitsByAxes(channel, AXES) }
  expect([0, 1].map(column => unitOf(told, column))).toEqual(units)
})

it('a column of no known axis keeps what the channel says', () => {
  expect(unitsByAxes({ unit: 'rad | m', columns: ['E1', 'x'] }, AXES)).toEqual(['m', 'rad | m'])
})

it.each(['rad', 'm/s', 'kg·m²', ''])('a channel of one unit has no others: %s', unit => {
  const channel = { unit, columns: ['1', 'E1'] }
  expect(unitsByAxes(channel, AXES)).toBeUndefined()
  expect(unitOf(channel, 1)).toBe(unit)
})
