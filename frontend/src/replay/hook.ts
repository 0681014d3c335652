/** What tests ask of a replay: numbers instead of pictures. */
import type { SceneDescription, Vector3 } from '../scene/description'
import type { StageStats } from '../scene/settings'
import type { Replay } from './replay'

export interface ReplayHook {
  readonly seek: (time: number) => void
  readonly time: () => number
  /** Name of each body that is shown → its pose in W. */
  readonly poses: () => Readonly<Record<string, readonly number[]>>
  /** Names of the bodies that are red, and the marks of collisions in W. */
  readonly colliding: () => unknown
  readonly project: (view: number | string, point: Vector3) => { x: number; y: number } | null
  readonly stats: () => StageStats
}

export function hookOf(replay: Replay, scene: SceneDescription): ReplayHook {
  const { cursor, picture } = replay
  return {
    seek: time => {
      cursor.pause()
      cursor.seek(time)
      replay.show()
    },
    time: () => cursor.time,
    poses: () =>
      Object.fromEntries(
        scene.bodies.flatMap(({ name }, body) =>
          picture.isVisible(body) ? [[name, picture.pose(body)] as const] : [],
        ),
      ),
    colliding: () => {
      const { bodies, marks } = picture.stage.colliding
      return { bodies: bodies.map(at => scene.bodies[at]?.name ?? ''), marks }
    },
    project: (view, point) => picture.stage.project(view, point),
    stats: () => picture.stage.stats(),
  }
}
