import { Matrix4, Object3D, Ray, Vector3 } from 'three'
import { beforeEach, describe, expect, it } from 'vitest'
import { Bodies, standsStill } from './bodies'
import type { Body, BodyKind, Pose, SceneDescription, Shape } from './description'
import type { Wardrobe } from './figure'
import { initialState } from './initial_state'
import { Look, matrixOf } from './look'
import { Looks } from './looks'
import { pick } from './picker'
import { words } from './words'

const HOME: Pose = [0, 0, 0, 1, 0, 0, 0]
const QUARTER = Math.SQRT1_2
const NAKED: Wardrobe = { of: () => null, order: () => 0, casts: () => false }

function cube(size: number, opacity = 1): Shape {
  return { kind: 'box', size: [size, size, size], pose: HOME, colour: '#ff0000', opacity, material: 'paint' }
}

function body(name: string, pose: Pose, parent = -1, kind: BodyKind = 'object', shapes = [cube(0.2)]): Body {
  return { name, kind, parent, pose, shapes, visible: true }
}

function sceneOf(bodies: Body[]): SceneDescription {
  const extent = { min: [0, 0, 0], max: [1, 1, 1] } as const
  return { version: 2, project: 'p', stations: [], bodies, frames: [], signals: [], extent }
}

describe('poses', () => {
  it('put the scalar of a quaternion first', () => {
    // A quarter turn about z takes x to y.
    const matrix = matrixOf([1, 2, 3, QUARTER, 0, 0, QUARTER])
    const moved = new Vector3(1, 0, 0).applyMatrix4(matrix)
    expect(moved.distanceTo(new Vector3(1, 3, 3))).toBeLessThan(1e-12)
  })

  it('at the start ride on their parents', () => {
    const scene = sceneOf([
      body('link', [0, 0, 1, QUARTER, 0, 0, QUARTER]),
      body('tool', [0.5, 0, 0, 1, 0, 0, 0], 0, 'tool'),
    ])
    const { poses, visible } = initialState(scene)
    const expected = [0, 0.5, 1, QUARTER, 0, 0, QUARTER]
    expected.forEach((value, k) => {
      expect(poses[7 + k]).toBeCloseTo(value, 6)
    })
    expect([...visible]).toEqual([1, 1])
  })
})

it('bases of robots and devices stand still, and what a device moves does not', () => {
  const still = ['left/base', 'infeed/base', 'table', 'infeed/link1', 'left/link1', 'post'].filter(
    (name, at) =>
      standsStill(
        body(name, HOME, -1, (['base', 'device', 'object', 'device', 'link', 'part'] as const)[at]),
      ),
  )
  expect(still).toEqual(['left/base', 'infeed/base', 'table'])
})

describe('bodies in the scene', () => {
  const parent = new Object3D()
  let bodies: Bodies
  const scene = sceneOf([
    body('base', HOME, -1, 'base'),
    ...[1, 2, 3, 4].map(k => body(`part ${k}`, [k, 0, 0, 1, 0, 0, 0], -1, 'part')),
  ])
  beforeEach(() => {
    parent.clear()
    bodies = new Bodies(parent, NAKED)
    bodies.load(scene, new Looks(words))
  })

  it('stand where they are shown', () => {
    const { poses, visible } = initialState(scene)
    poses.set([0, 5, 0, QUARTER, QUARTER, 0, 0], 14)
    expect(bodies.show(poses, visible)).toBe(true)
    expect(bodies.matrix(2)?.equals(bodies.read(poses, 2, new Matrix4()))).toBe(true)
    expect(bodies.boxOf(2).getCenter(new Vector3()).y).toBeCloseTo(5, 6)
    expect([...(bodies.poseOf(2) ?? [])]).toEqual([...poses.subarray(14, 21)])
    expect(bodies.poseOf(9)).toBeNull()
  })

  it('tell whether anything has changed, and take no short arrays', () => {
    const { poses, visible } = initialState(scene)
    expect(bodies.show(poses, visible)).toBe(false)
    expect(bodies.show(poses.subarray(7), visible)).toBe(false)
    visible[3] = 0
    expect(bodies.show(poses, visible)).toBe(true)
    expect(bodies.shown(3)).toBe(false)
  })

  it('alike are drawn in one go', () => {
    // Five equal cubes: one group holds those that are no part of the robot.
    const arm = scene.bodies.filter(({ kind }) => ['base', 'link', 'tool'].includes(kind)).length
    expect(arm).toBe(1)
    expect(parent.children.length).toBe(1 + arm)
    // Three are too few for a group.
    bodies.setOpacity(2, 0.5)
    expect(parent.children.length).toBe(scene.bodies.length)
    bodies.setOpacity(2, 1)
    expect(parent.children.length).toBe(1 + arm)
  })

  it('are hit by the nearest surface on a line of sight, hidden ones never', () => {
    const ray = new Ray(new Vector3(9, 0, 0.05), new Vector3(-1, 0, 0))
    expect(pick(bodies, ray)?.body).toBe(4)
    expect(pick(bodies, ray)?.point.distanceTo(new Vector3(4.1, 0, 0.05))).toBeLessThan(1e-6)
    bodies.setHidden(4, true)
    expect(pick(bodies, ray)?.body).toBe(3)
    bodies.setOpacity(3, 0)
    expect(pick(bodies, ray)?.body).toBe(2)
    expect(pick(bodies, new Ray(new Vector3(9, 0, 1), new Vector3(-1, 0, 0)))).toBeNull()
  })

  it('stay hidden by name when the cell is read again', () => {
    bodies.setHidden(2, true)
    bodies.load(sceneOf(scene.bodies.slice(1)), new Looks(words))
    expect([0, 1, 2, 3].map(k => bodies.shown(k))).toEqual([true, false, true, true])
  })

  it('leave their feet on the floor', () => {
    // The base is a cube about the origin: its lower face is at -0.1.
    const feet = bodies.footprints(-0.1)
    expect(feet.length).toBe(1)
    expect(feet[0]?.max.toArray()).toEqual([0.1, 0.1, -0.1].map(value => expect.closeTo(value, 6)))
    expect(bodies.footprints(-0.5)).toEqual([])
  })
})

describe('a look', () => {
  const none = new Map()

  it('makes one surface of all opaque shapes and another of each transparency', () => {
    const look = new Look([cube(1), cube(0.5), cube(2, 0.5)], none, new Set())
    const surfaces = look.pieces.filter(({ role }) => role === 'surface')
    expect(surfaces.map(({ opacity }) => opacity)).toEqual([1, 0.5])
    expect(surfaces.map(({ geometry }) => (geometry.getIndex()?.count ?? 0) / 3)).toEqual([24, 12])
    expect(look.box.max.x).toBe(1)
  })

  it('moves shapes to their poses, normals with them', () => {
    const shape: Shape = { ...cube(0.2), pose: [1, 0, 0, QUARTER, 0, QUARTER, 0] }
    const [surface] = [...new Look([shape], none, new Set()).surfaces()]
    const normals = surface?.getAttribute('normal')
    expect(surface?.boundingBox?.min.x).toBeCloseTo(0.9, 6)
    // The lower cap comes first; turned about y by a quarter its normal -z becomes -x.
    expect(normals?.getX(0)).toBeCloseTo(-1, 6)
  })

  it('stands a hatched box where a mesh is missing, and nothing where it is on its way', () => {
    const mesh = (address: string): Shape => {
      return {
        kind: 'mesh',
        mesh: address,
        file: 'x.stl',
        missing: '',
        pose: HOME,
        colour: '#ffffff',
        opacity: 1,
        material: 'paint',
      }
    }
    const roles = (shape: Shape, failed: string[]) =>
      new Look([shape], none, new Set(failed)).pieces.map(({ role }) => role)
    expect(roles(mesh(''), [])).toContain('missing')
    expect(roles(mesh('abc'), ['abc'])).toContain('missing')
    expect(roles(mesh('abc'), [])).toEqual([])
  })

  it('is one and the same for equal shapes', () => {
    const looks = new Looks(words)
    expect(looks.of([cube(0.3)])).toBe(looks.of([cube(0.3)]))
    expect(looks.of([cube(0.3)])).not.toBe(looks.of([cube(0.4)]))
  })
})

describe('meshes', () => {
  it('that cannot be had are told with body, file and reason', async () => {
    const shape = (mesh: string, file: string, missing: string): Shape => {
      return {
        kind: 'mesh',
        mesh,
        file,
        missing,
        pose: HOME,
        colour: '#ffffff',
        opacity: 1,
        material: 'paint',
      }
    }
    const list = [
      body('engine', HOME, -1, 'object', [shape('', 'a.stl', 'file not found')]),
      body('cover', HOME, -1, 'object', [shape('f00d', 'b.stl', '')]),
    ]
    const looks = new Looks(words)
    expect(looks.problems(list)).toEqual([{ body: 'engine', file: 'a.stl', reason: 'file not found' }])
    const refuse = () => Promise.reject(new Error('HTTP 404'))
    await new Promise<void>(resolve => looks.fetch(list, refuse, resolve))
    expect(looks.problems(list)[1]).toEqual({
      body: 'cover',
      file: 'b.stl',
      reason: 'could not be loaded (HTTP 404)',
    })
  })
})
