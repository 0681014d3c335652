import { expect, test } from 'vitest'
import { pastedNumbers } from './pasted_numbers'

const THREE = ['412.5', '-147.5', '600']

test.each([
  '412.5, -147.5, 600',
  '412.5,-147.5,600',
  '412.5 -147.5 600',
  '  (412.5, -147.5, 600)\n',
  '412.5\t-147.5\t600',
  '412.5; -147.5; 600',
  '412,5\t-147,5\t600',
  '412,5; -147,5; 600',
  '412,5, -147,5, 600',
  '412,5 -147,5 600',
  '412.5 mm, −147.5 mm, 600 mm',
  'feeder\t412.5\t-147.5\t600',
  'feeder,412.5,-147.5,600,,',
  '[412.5, -147.5, 600]',
])('three numbers are read as they are copied: %j', text => {
  expect(pastedNumbers(text)).toEqual(THREE)
})

test('angles come along', () => {
  expect(pastedNumbers('412.5, -147.5, 600, 90, 0')).toEqual([...THREE, '90', '0'])
  expect(pastedNumbers('p1\t412,5\t-147,5\t600\t90\t0\t-36,9')).toEqual([...THREE, '90', '0', '-36.9'])
})

test.each([
  '',
  '412.5',
  '1, 2',
  '1 2 3 4',
  'a, b, c',
  '1, 2, x',
  '1,2,3\n4,5,6',
  'lin (1, 2, 3)',
  '1e, 2, 3',
])('what is no point is left to the field: %j', text => {
  expect(pastedNumbers(text)).toEqual([])
})
