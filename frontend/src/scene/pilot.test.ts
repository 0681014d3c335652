import { Box3, Vector3 } from 'three'
import { beforeEach, describe, expect, it } from 'vitest'
import { cornersOf, DIRECTIONS } from './camera_pose'
import { Pilot } from './pilot'
import { type Key, pressKey } from './view_keys'

const BOX = cornersOf(new Box3(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1)))
const HIT = new Vector3(0.2, -0.5, 0.4)

let moves = 0
let names = 0

function pilotOf(id: keyof typeof DIRECTIONS, reducedMotion = true): Pilot {
  const context = { reducedMotion, hit: () => HIT.clone(), floor: () => 0 }
  const pilot = new Pilot(
    id,
    context,
    () => {
      moves += 1
    },
    () => {
      names += 1
    },
  )
  pilot.resize(640, 400)
  return pilot
}

function pixel(pilot: Pilot, point: Vector3): [number, number] {
  const { x, y } = pilot.view.project(point, new Vector3())
  return [(0.5 + 0.5 * x) * 640, (0.5 - 0.5 * y) * 400]
}

describe('a camera that is moved', () => {
  beforeEach(() => {
    moves = 0
    names = 0
  })

  it('keeps the point under the pointer there while it turns and zooms', () => {
    const pilot = pilotOf('perspective')
    pilot.home(BOX)
    const [x, y] = pixel(pilot, HIT)
    pilot.anchorAt(x, y)
    pilot.turn(0.4, 0.1)
    pilot.zoom(0.7)
    expect(pixel(pilot, HIT)[0]).toBeCloseTo(x, 6)
    expect(pixel(pilot, HIT)[1]).toBeCloseTo(y, 6)
    expect(moves).toBeGreaterThan(2)
  })

  it('is called custom once a named direction has been turned away, and says so once', () => {
    const pilot = pilotOf('top')
    pilot.turn(0, -0.2)
    pilot.turn(0, -0.2)
    expect(pilot.preset).toBe('custom')
    expect(names).toBe(1)
    const perspective = pilotOf('perspective')
    perspective.turn(0.3, 0)
    expect(perspective.preset).toBe('perspective')
  })

  it('goes on showing all when the window changes, until it is moved by hand', () => {
    const pilot = pilotOf('front')
    pilot.home(BOX)
    const wide = pilot.view.pose.distance
    pilot.resize(200, 400)
    expect(pilot.view.pose.distance).toBeGreaterThan(1.5 * wide)
    pilot.resize(640, 400)
    expect(pilot.view.pose.distance).toBeCloseTo(wide, 9)
    pilot.anchorInMiddle()
    pilot.zoom(0.5)
    pilot.resize(200, 400)
    expect(pilot.view.pose.distance).toBeCloseTo(wide / 2, 9)
  })

  it('shows things as large as can be, but not below the buttons at the top left', () => {
    const pilot = pilotOf('front')
    const top = (points: Vector3[]) => {
      pilot.home(points)
      return Math.min(...points.map(point => pixel(pilot, point)[1]))
    }
    const slim = cornersOf(new Box3(new Vector3(-0.3, 0, 0), new Vector3(0.3, 0.1, 1)))
    expect(top(slim)).toBeLessThan(20)
    const wide = cornersOf(new Box3(new Vector3(-1, 0, 0), new Vector3(0.6, 0.1, 1)))
    expect(top(wide)).toBeGreaterThan(34)
  })

  it('shows what comes later, too, but not once it was moved by hand', () => {
    const pilot = pilotOf('front')
    const more = [...BOX, new Vector3(3, 0, 0)]
    pilot.home(BOX)
    pilot.grown(more)
    expect(Math.max(...more.map(point => pixel(pilot, point)[0]))).toBeLessThan(640)
    pilot.anchorInMiddle()
    pilot.zoom(0.5)
    const before = pilot.state
    pilot.grown(more)
    expect(pilot.state).toEqual(before)
  })

  it('glides to a direction and arrives', () => {
    const pilot = pilotOf('perspective', false)
    const [azimuth, elevation] = DIRECTIONS.right
    pilot.look('right')
    expect(pilot.step(1000)).toBe(true)
    expect(pilot.step(1100)).toBe(true)
    expect(pilot.view.pose.elevation).toBeLessThan(DIRECTIONS.perspective[1])
    expect(pilot.view.pose.elevation).toBeGreaterThan(elevation)
    expect(pilot.step(2000)).toBe(false)
    expect(pilot.view.pose.azimuth).toBeCloseTo(azimuth, 9)
    expect(pilot.step(2100)).toBe(false)
  })

  it('comes back to what was kept', () => {
    const pilot = pilotOf('perspective')
    pilot.home(BOX)
    pilot.turn(0.3, 0.2)
    pilot.switchProjection()
    const kept = JSON.parse(JSON.stringify(pilot.state))
    pilot.look('top')
    pilot.restore(kept)
    expect(pilot.state).toEqual(kept)
  })
})

describe('keys of a viewport', () => {
  const key = (name: string, held: Partial<Key> = {}): Key => {
    return { key: name, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, ...held }
  }
  const actions = { fitSelection: () => {}, fitAll: () => {} }

  it('look from the sides they are known for', () => {
    const pilot = pilotOf('perspective')
    const looks = ['1 front', '3 right', '7 top', '0 perspective']
    for (const [name = '', preset] of looks.map(look => look.split(' '))) {
      expect(pressKey(pilot, key(name), actions)).toBe(true)
      expect(pilot.preset).toBe(preset)
    }
    pressKey(pilot, key('5'), actions)
    expect(pilot.view.projection).toBe('parallel')
  })

  it('turn, move and zoom', () => {
    const pilot = pilotOf('perspective')
    const { azimuth, target, distance } = pilot.view.pose
    pressKey(pilot, key('ArrowRight'), actions)
    expect(pilot.view.pose.azimuth).toBeGreaterThan(azimuth)
    expect(pilot.view.pose.target[0]).toBeCloseTo(target[0], 9)
    pressKey(pilot, key('ArrowUp', { shiftKey: true }), actions)
    expect(pilot.view.pose.target[2]).toBeGreaterThan(target[2])
    pressKey(pilot, key('+'), actions)
    expect(pilot.view.pose.distance).toBeLessThan(distance)
  })

  it('leave other keys, and those of the browser, alone', () => {
    const pilot = pilotOf('perspective')
    for (const event of [key('x'), key('Tab'), key('1', { ctrlKey: true }), key('f', { metaKey: true })]) {
      expect(pressKey(pilot, event, actions)).toBe(false)
    }
    expect(pilot.preset).toBe('perspective')
  })
})
