import { Box3, Ray, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { between, cornersOf, DIRECTIONS, eyeOf, lookFrom, orbit, pan, zoom } from './camera_pose'
import type { CameraPose, Projection } from './settings'
import { ViewCamera } from './view_camera'

const POSE: CameraPose = { target: [0.3, -0.2, 0.6], azimuth: -0.9, elevation: 0.4, distance: 2.5 }
const POINT = new Vector3(0.55, -0.4, 0.42)
const PROJECTIONS: Projection[] = ['perspective', 'parallel']

function camera(projection: Projection, pose = POSE): ViewCamera {
  const made = new ViewCamera()
  made.setAspect(1.6)
  made.set(pose, projection)
  return made
}

function place(view: ViewCamera, point = POINT): Vector3 {
  return view.project(point, new Vector3())
}

describe.each(PROJECTIONS)('a camera in %s projection', projection => {
  it('sends a line of sight through the place of a point that meets the point', () => {
    const view = camera(projection)
    const { x, y } = place(view)
    const ray = view.ray(x, y, new Ray())
    expect(ray.direction.length()).toBeCloseTo(1, 12)
    expect(ray.distanceToPoint(POINT)).toBeLessThan(1e-9)
  })

  it('turns about a point that keeps its place in the picture', () => {
    const view = camera(projection)
    const before = place(view)
    view.set(orbit(POSE, POINT, 0.7, 0.3, 0))
    expect(view.pose.azimuth).toBeCloseTo(POSE.azimuth + 0.7, 12)
    expect(view.pose.elevation).toBeCloseTo(POSE.elevation + 0.3, 12)
    expect(place(view).x).toBeCloseTo(before.x, 9)
    expect(place(view).y).toBeCloseTo(before.y, 9)
  })

  it('zooms towards a point that keeps its place in the picture', () => {
    const view = camera(projection)
    const before = place(view)
    view.set(zoom(POSE, POINT, 0.5))
    expect(view.pose.distance).toBeCloseTo(POSE.distance / 2, 12)
    expect(place(view).x).toBeCloseTo(before.x, 9)
    expect(place(view).y).toBeCloseTo(before.y, 9)
  })

  it('pans so that a point follows the pointer', () => {
    const view = camera(projection)
    const before = place(view)
    view.set(pan(POSE, 0.1, -0.05, view.depth(POINT)))
    // Shares of the height of the picture, which is 2 in y and 2 × aspect in x.
    expect(place(view).x - before.x).toBeCloseTo((2 * 0.1) / 1.6, 9)
    expect(place(view).y - before.y).toBeCloseTo(2 * -0.05, 9)
  })

  it.each(Object.entries(DIRECTIONS))(
    'fits a box from the direction %s so that it just fills it',
    (_, [a, e]) => {
      const view = camera(projection, lookFrom(POSE, a, e))
      const box = new Box3(new Vector3(-0.5, -0.9, 0), new Vector3(1.1, 0.4, 1.7))
      view.set(view.fitted(cornersOf(box)))
      const at = cornersOf(box).map(corner => place(view, corner))
      const greatest = Math.max(...at.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]))
      expect(greatest).toBeLessThan(0.95)
      expect(greatest).toBeGreaterThan(0.91)
      expect(Math.max(...at.map(({ z }) => Math.abs(z)))).toBeLessThan(1)
    },
  )

  it('leaves the upper part of the picture free for buttons', () => {
    const view = camera(projection, lookFrom(POSE, -0.9, 0.4))
    const box = new Box3(new Vector3(-0.1, -0.1, 0), new Vector3(0.1, 0.1, 1.7))
    view.set(view.fitted(cornersOf(box), 0.2))
    const heights = cornersOf(box).map(corner => place(view, corner).y)
    // A fifth of the height, which runs from -1 to 1, is 0.4.
    expect(Math.max(...heights)).toBeLessThan(0.6)
    expect(Math.max(...heights)).toBeGreaterThan(0.5)
    expect(Math.min(...heights)).toBeGreaterThan(-1)
    expect(Math.min(...heights)).toBeLessThan(-0.9)
  })
})

describe('directions of view', () => {
  it('top shows x to the right and y up; front x and z; right y and z', () => {
    const axes = { top: ['x', 'y'], front: ['x', 'z'], right: ['y', 'z'] } as const
    for (const [name, [horizontal, vertical]] of Object.entries(axes)) {
      const [azimuth, elevation] = DIRECTIONS[name as keyof typeof axes]
      const view = camera('parallel', { ...lookFrom(POSE, azimuth, elevation), target: [0, 0, 0] })
      const step = (axis: 'x' | 'y' | 'z') =>
        place(view, new Vector3().setComponent('xyz'.indexOf(axis), 0.1))
      expect(step(horizontal).x).toBeGreaterThan(0.05)
      expect(step(horizontal).y).toBeCloseTo(0, 9)
      expect(step(vertical).y).toBeGreaterThan(0.05)
      expect(step(vertical).x).toBeCloseTo(0, 9)
    }
  })

  it('both projections show a point of the target plane at the same place', () => {
    const inPlane = new Vector3(...POSE.target).add(new Vector3(-Math.sin(-0.9), Math.cos(-0.9), 0))
    expect(place(camera('parallel'), inPlane).x).toBeCloseTo(place(camera('perspective'), inPlane).x, 9)
  })
})

describe('turning', () => {
  it('stops overhead and a little below the horizon', () => {
    expect(orbit(POSE, POINT, 0, 9, 0).elevation).toBeCloseTo(Math.PI / 2, 12)
    expect(orbit({ ...POSE, target: [0, 0, 5] }, POINT, 0, -9, 0).elevation).toBeCloseTo(
      (-5 * Math.PI) / 180,
      12,
    )
  })

  it('does not take the eye below the floor', () => {
    const low: CameraPose = { ...POSE, target: [0, 0, 0.1], elevation: 0.02 }
    for (const pivot of [new Vector3(0, 0, 0), new Vector3(0, 0, 1.5)]) {
      for (const tilt of [-0.01, -0.1, -1]) {
        expect(eyeOf(orbit(low, pivot, 0.2, tilt, 0)).z).toBeGreaterThanOrEqual(0)
      }
    }
  })

  it('glides the short way round', () => {
    const from = lookFrom(POSE, 3, 0.4)
    const to = lookFrom(POSE, -3, 0.4)
    expect(Math.abs(between(from, to, 0.5).azimuth)).toBeCloseTo(Math.PI, 2)
    expect(between(from, to, 0)).toEqual(from)
    expect(between(from, to, 1).distance).toBeCloseTo(to.distance, 12)
  })
})
