import { expect, test } from 'vitest'
import { UndoStack } from './undo'

function bench() {
  const stack = new UndoStack()
  let value = 0
  const set = (to: number) => {
    const from = value
    stack.do({ name: `to ${to}`, undo: () => (value = from), redo: () => (value = to) })
  }
  return { stack, set, value: () => value }
}

test('undo and redo go back and forth through what was done', () => {
  const { stack, set, value } = bench()
  for (const to of [1, 2, 3]) set(to)
  stack.undo()
  stack.undo()
  expect(value()).toBe(1)
  expect([stack.next, stack.nextRedo]).toEqual(['to 1', 'to 2'])
  stack.redo()
  expect(value()).toBe(2)
})

test('a step that was undone in another way is passed over, and heard of', () => {
  const { stack, set, value } = bench()
  set(1)
  let stands = true
  let undone = 0
  stack.did({ name: 'elsewhere', stands: () => stands, undo: () => undone++, redo: () => undone-- })
  let heard = 0
  stack.onChange(() => heard++)
  stack.look()
  expect([stack.next, heard]).toEqual(['elsewhere', 0])
  stands = false
  stack.look()
  expect([stack.next, stack.names, heard]).toEqual(['to 1', ['to 1'], 1])
  stack.undo()
  expect([value(), undone, stack.next]).toEqual([0, 0, null])
})

test('something new forgets what was undone', () => {
  const { stack, set, value } = bench()
  set(1)
  set(2)
  stack.undo()
  set(5)
  stack.redo()
  expect(value()).toBe(5)
  expect(stack.names).toEqual(['to 5', 'to 1'])
})

test('an empty stack does nothing, and listeners hear of every change', () => {
  const { stack, set } = bench()
  let heard = 0
  const stop = stack.onChange(() => heard++)
  stack.undo()
  stack.redo()
  expect(heard).toBe(0)
  set(1)
  stack.undo()
  stop()
  stack.redo()
  expect(heard).toBe(2)
})

test('only the newest two hundred steps are kept', () => {
  const { stack, set } = bench()
  for (let to = 1; to <= 250; to++) set(to)
  expect(stack.names).toHaveLength(200)
  expect(stack.next).toBe('to 250')
})
