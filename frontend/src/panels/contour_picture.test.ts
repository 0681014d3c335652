import { expect, test } from 'vitest'
import type { Contour } from '../run/run'
import { contourPicture, HEIGHT, WIDTH } from './contour_picture'

const SQUARE: Contour['wanted'] = [
  [0, 0],
  [0.1, 0],
  [0.1, 0.1],
  [0, 0.1],
  [0, 0],
]

function contour(attained: Contour['attained']): Contour {
  return {
    station: 'robot',
    name: 'lines 1 to 4',
    start: 0,
    end: 2,
    path_max: 0.001,
    path_mean: 0.0005,
    time: 1,
    tracking_max: 0.01,
    tracking_end: 0.002,
    overshoot: null,
    axes: ['x', 'z'],
    factor: 5,
    wanted: SQUARE,
    attained,
  }
}

const points = (text: string) => text.split(' ').map(one => one.split(',').map(Number) as [number, number])

test('scales are equal and the second axis points upwards', () => {
  const [first, second, third] = points(contourPicture(contour([])).wanted)
  if (!first || !second || !third) throw new Error('a corner is missing')
  expect(second[0] - first[0]).toBeCloseTo(first[1] - third[1], 6)
  expect(second[0] - first[0]).toBeGreaterThan(100)
  expect(second[1]).toBeCloseTo(first[1], 6)
})

test('all of both curves is inside the picture', () => {
  const far: Contour['attained'] = [
    [-0.2, 0],
    [0.05, 0.4],
  ]
  const picture = contourPicture(contour(far))
  for (const [x, y] of [...points(picture.wanted), ...points(picture.attained)]) {
    expect(x).toBeGreaterThanOrEqual(0)
    expect(x).toBeLessThanOrEqual(WIDTH)
    expect(y).toBeGreaterThanOrEqual(0)
    expect(y).toBeLessThanOrEqual(HEIGHT)
  }
})
