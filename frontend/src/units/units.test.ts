import { afterEach, expect, test } from 'vitest'
import { METRIC, setUnits } from './choice'
import { calculate, parseQuantity } from './parse'
import { compose, poseOf, rollPitchYaw, stepInWorld } from './pose'
import { formatPlain, formatQuantity } from './quantity'

test('angles are shown in degrees, lengths in millimetres, with their unit', () => {
  expect(formatQuantity(Math.PI / 2, 'rad')).toBe('90.00°')
  expect(formatQuantity(0.0125, 'm')).toBe('12.5 mm')
  expect(formatQuantity(3, 'N·m')).toBe('3.00 N·m')
  expect(formatQuantity(7.818e6, 'Pa')).toBe('78.2 bar')
  expect(formatQuantity(Number.NaN, 'm')).toBe('– mm')
})

afterEach(() => setUnits(METRIC))

test('speeds and accelerations follow their lengths and angles', () => {
  expect(formatQuantity(1, 'rad/s')).toBe('57.3°/s')
  expect(formatQuantity(1, 'rad/s²')).toBe('57°/s²')
  expect(formatQuantity(0.25, 'm/s')).toBe('250.0 mm/s')
})

test('inches, metres and radians are shown and read where they are chosen', () => {
  setUnits({ length: 'in', angle: 'rad' })
  expect(formatQuantity(0.0254, 'm')).toBe('1.000 in')
  expect(formatQuantity(1.5, 'rad')).toBe('1.5000 rad')
  expect(parseQuantity('2', 'length')).toEqual({ value: 0.0508 })
  expect(parseQuantity('2', 'angle')).toEqual({ value: 2 })
  setUnits({ length: 'm', angle: 'deg' })
  expect(formatQuantity(0.25, 'm/s')).toBe('0.2500 m/s')
})

test('nothing is shown as minus zero', () => {
  expect(formatQuantity(-1e-9, 'rad')).toBe('0.00°')
})

test('plain values are whole numbers where they can be', () => {
  expect(formatPlain(17)).toBe('17')
  expect(formatPlain(0.25)).toBe('0.250')
})

test.each([
  ['12.5 mm', 'length', 0.0125],
  ['12.5', 'length', 0.0125],
  ['1 in', 'length', 0.0254],
  ['13*2', 'length', 0.026],
  ['(1 + 2) / 3 m', 'length', 1],
  ['90 deg', 'angle', Math.PI / 2],
  ['90', 'angle', Math.PI / 2],
  ['90°', 'angle', Math.PI / 2],
  ['1 rad', 'angle', 1],
  ['−45', 'angle', -Math.PI / 4],
  ['2,5 cm', 'length', 0.025],
] as const)('%s is read as a quantity', (text, dimension, expected) => {
  const parsed = parseQuantity(text, dimension)
  expect('value' in parsed && parsed.value).toBeCloseTo(expected, 12)
})

test.each(['', 'abc', '12 kg', '90 deg', '1/0', '(1', '1 2', '*3'])('%s is no length', text => {
  const parsed = parseQuantity(text, 'length')
  expect('mistake' in parsed && parsed.mistake.length > 10).toBe(true)
})

test('sums follow the order of operations', () => {
  expect(calculate('1 + 2 * 3 - 4 / 2')).toBe(5)
  expect(calculate('-(2 - 5) * 2')).toBe(6)
  expect(calculate('2e-3*1e3')).toBe(2)
})

test('roll, pitch and yaw come back from the pose that they make', () => {
  for (const angles of [
    [0.3, -0.8, 2.1],
    [-3, 1.5, -0.2],
    [0, 0, 0],
  ] as const) {
    const back = rollPitchYaw(poseOf([1, 2, 3], angles))
    for (const at of [0, 1, 2] as const) expect(back[at]).toBeCloseTo(angles[at], 9)
  }
})

test.each([1, -1])('straight up and down all of the turn is in the yaw (%d)', sign => {
  const pose = poseOf([0, 0, 0], [0, (sign * Math.PI) / 2, 0.7])
  const [roll, pitch, yaw] = rollPitchYaw(pose)
  expect(roll).toBe(0)
  expect(pitch).toBeCloseTo((sign * Math.PI) / 2, 6)
  expect(yaw).toBeCloseTo(0.7, 6)
})

test('yaw turns x towards y', () => {
  const turned = compose(poseOf([0, 0, 0], [0, 0, Math.PI / 2]), poseOf([1, 0, 0], [0, 0, 0]))
  expect(turned[0]).toBeCloseTo(0, 12)
  expect(turned[1]).toBeCloseTo(1, 12)
})

test('a step in the world moves along its axes and turns on the spot', () => {
  const start = poseOf([1, 2, 3], [0.4, 0.2, -1])
  const moved = stepInWorld(start, poseOf([0.1, 0, 0], [0, 0, 0]))
  expect(moved.slice(0, 3)).toEqual([1.1, 2, 3])
  const turned = stepInWorld(start, poseOf([0, 0, 0], [0, 0, 0.5]))
  expect(turned.slice(0, 3)).toEqual([1, 2, 3])
  expect(rollPitchYaw(turned)[2]).toBeCloseTo(-0.5, 9)
})

test('a step in the tool goes where the tool points', () => {
  const start = poseOf([0, 0, 1], [Math.PI, 0, 0])
  const moved = compose(start, poseOf([0, 0, 0.1], [0, 0, 0]))
  expect(moved[2]).toBeCloseTo(0.9, 12)
})
