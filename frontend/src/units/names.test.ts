import { expect, test } from 'vitest'
import { channelName, columnLabel, columnName, quantityName, symbolOf } from './names'

test('numbers of a joint are named after the joint and what they measure', () => {
  expect(columnName('q', '1')).toBe('Joint 1 position')
  expect(columnName('tau', '6')).toBe('Joint 6 torque')
  expect(columnName('qd', 'rail')).toBe('rail speed')
  expect(columnName('pressure_a', 'lift')).toBe('lift pressure A')
})

test('where the quantity is told already a column is its joint', () => {
  expect(channelName('qd_ref')).toBe('Commanded speed')
  expect(columnLabel('qd_ref', '2')).toBe('Joint 2')
  expect(columnLabel('attained_position', 'x')).toBe('x')
})

test('other numbers have names of their own, signals those of the cell', () => {
  expect(columnName('attained_position', 'z')).toBe('TCP position z')
  expect(columnName('path_error', '')).toBe('Path error')
  expect(columnName('signal.box_ready', '')).toBe('box_ready')
  expect(columnName('my_own', 'a')).toBe('my_own a')
})

test('the symbol of the model is at hand', () => {
  expect(symbolOf('qd', '3')).toBe('qd 3')
  expect(symbolOf('path_error', '')).toBe('path_error')
})

test('what is of a station or device has its name before it', () => {
  expect(columnName('left/tau', '6')).toBe('left: Joint 6 torque')
  expect(channelName('left/attained_position')).toBe('left: TCP position')
  expect(columnLabel('left/qd', '2')).toBe('Joint 2')
  expect(quantityName('path_error')).toBe('Path error')
  expect(columnName('signal.a/b', '')).toBe('a/b')
})
