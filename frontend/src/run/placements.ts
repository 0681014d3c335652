/** Where the bodies of a scene are that no series of poses tells: fixed ones, and parts that ride or rest. */
import type { SceneDescription } from '../scene/description'
import type { Placement } from './pack_file'
import { put, ride } from './pose'
import { countUpTo } from './search'

export class Placements {
  readonly #scene: SceneDescription
  readonly #places: readonly number[]
  readonly #placed = new Map<number, Placement[]>()

  /**
   * @param names of the bodies of the run, in the order in which the run counts them. The scene may be of a
   *   newer cell: a body is the one at the same place if that has its name, else the one of that name.
   */
  constructor(scene: SceneDescription, names: readonly string[]) {
    this.#scene = scene
    this.#places = names.map((name, index) =>
      scene.bodies[index]?.name === name ? index : scene.bodies.findIndex(body => body.name === name),
    )
  }

  /** Place in the scene of a body of the run; -1 where the scene lacks it. */
  placeOf(body: number): number {
    return this.#places[body] ?? -1
  }

  /** Add what holds for a body of the run from a time on; times of one body ascend. */
  add(body: number, placement: Placement): void {
    const place = this.placeOf(body)
    if (place < 0) return
    const { parent } = placement
    const here = { ...placement, parent: parent < 0 ? -1 : this.placeOf(parent) }
    const known = this.#placed.get(place)
    if (known) known.push(here)
    else this.#placed.set(place, [here])
  }

  /** Write the bodies of the scene for which `tracked` is 0; those they ride on come before them. */
  write(time: number, poses: Float32Array, visible: Uint8Array, tracked: Uint8Array): void {
    const { bodies } = this.#scene
    for (let body = 0; body < bodies.length; body++) {
      const start = bodies[body]
      if (!start) continue
      if (tracked[body]) {
        visible[body] = start.visible ? 1 : 0
        continue
      }
      const { parent, pose, visible: seen } = this.#at(body, time) ?? start
      if (parent >= 0 && parent < body) ride(poses, body, parent, pose)
      else put(poses, body, pose)
      visible[body] = seen ? 1 : 0
    }
  }

  #at(body: number, time: number): Placement | undefined {
    const placed = this.#placed.get(body)
    return placed?.[countUpTo(placed, time, timeOf) - 1]
  }
}

function timeOf(placement: Placement): number {
  return placement.time
}
