/** Where the bodies of a scene are that no series of poses tells: fixed ones, and parts that ride or rest. */
import type { SceneDescription } from '../scene/description'
import type { Placement } from './pack_file'
import { put, ride } from './pose'
import { countUpTo } from './search'

export class Placements {
  readonly #scene: SceneDescription
  readonly #placed = new Map<number, Placement[]>()

  constructor(scene: SceneDescription) {
    this.#scene = scene
  }

  /** Add what holds for a body from a time on; times of one body ascend. */
  add(body: number, placement: Placement): void {
    const known = this.#placed.get(body)
    if (known) known.push(placement)
    else this.#placed.set(body, [placement])
  }

  /** Write the bodies for which `tracked` is 0; those they ride on come before them in the scene. */
  write(time: number, poses: Float32Array, visible: Uint8Array, tracked: Uint8Array): void {
    for (const [body, start] of this.#scene.bodies.entries()) {
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
