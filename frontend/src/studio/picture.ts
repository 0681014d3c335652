/** What the 3-D stage is told: poses of the run at the cursor, trails, the ghost and the jogged arm. */
import { contactsAt } from '../run/contacts'
import type { Cursor } from '../run/cursor'
import type { Run } from '../run/run'
import type { Pose, SceneDescription } from '../scene/description'
import { type Move, movesAmong, pathWindow } from '../scene/path_window'
import type { PointMark } from '../scene/point_marks'
import type { Stage } from '../scene/stage'
import { compose } from '../units/pose'
import { ask } from '../wire/entry'
import type { Jogged } from '../wire/messages'
import { applyLook, DEFAULT_LOOK, type Look } from './look'

export class Picture {
  readonly #cursor: Cursor
  #stage: Stage | null = null
  #scene: SceneDescription | null = null
  #run: Run | null = null
  /** What the robots are yet to do, by station; a live run does not know. */
  #moves: readonly (readonly Move[])[] = []
  #ghostTime: number | null = null
  #jogged: Jogged | null = null
  #look: Look = DEFAULT_LOOK
  #stale = false
  #points: readonly PointMark[] = []
  #poses = new Float32Array(0)
  #visible = new Uint8Array(0)

  constructor(cursor: Cursor) {
    this.#cursor = cursor
  }

  get stage(): Stage | null {
    return this.#stage
  }

  /** World poses that are shown, seven numbers for each body of the scene. */
  get poses(): Float32Array {
    return this.#poses
  }

  /** World poses of the ghost; null for none. */
  get ghostPoses(): Float32Array | null {
    if (this.#ghostTime === null || !this.#run) return null
    const poses = this.#poses.slice()
    this.#run.bodies(this.#ghostTime, poses, new Uint8Array(this.#visible.length))
    return poses
  }

  /** World poses of the jogged arm; null for none. */
  get joggedPoses(): Float32Array | null {
    if (!this.#jogged) return null
    const poses = this.#poses.slice()
    for (const { body, pose } of this.#jogged.bodies) if (7 * body < poses.length) poses.set(pose, 7 * body)
    this.#scene?.bodies.forEach(({ kind, parent, pose }, at) => {
      if (kind === 'tool' && parent >= 0) poses.set(compose(poseAt(poses, parent), pose), 7 * at)
    })
    return poses
  }

  attach(stage: Stage): void {
    this.#stage = stage
    stage.stale(this.#stale)
    applyLook(stage, this.#look, null)
    stage.points(this.#points)
    if (this.#scene) this.setScene(this.#scene)
  }

  detach(): void {
    this.#stage = null
  }

  setScene(scene: SceneDescription): void {
    this.#scene = scene
    // It counts the bodies of the scene before; whoever jogs asks again.
    this.#jogged = null
    this.#poses = new Float32Array(7 * scene.bodies.length)
    this.#visible = new Uint8Array(scene.bodies.length)
    restAt(scene, this.#poses, this.#visible)
    this.#stage?.load(scene, fetchMesh)
    if (this.#stage) applyLook(this.#stage, this.#look, scene)
    this.refresh()
  }

  setRun(run: Run): void {
    this.#run = run
    this.#moves = run.stations.map(({ name }) => (run.live ? [] : movesAmong(run.events, name)))
    this.refresh()
  }

  ghost(time: number | null): void {
    this.#ghostTime = time
    this.#showGhost()
  }

  jogged(answer: Jogged | null): void {
    this.#jogged = answer
    this.#stage?.jogged(this.joggedPoses)
  }

  /** Points of a program that is being put together. */
  points(points: readonly PointMark[]): void {
    this.#points = points
    this.#stage?.points(points)
  }

  stale(on: boolean): void {
    this.#stale = on
    this.#stage?.stale(on)
  }

  setLook(look: Look): void {
    this.#look = look
    if (this.#stage) applyLook(this.#stage, look, this.#scene)
    this.grown()
    this.update()
  }

  /** The live run has more samples. */
  grown(): void {
    const run = this.#look.path === 'none' ? null : this.#run
    const trails = (kind: 'attained' | 'command') =>
      run?.stations.map(({ name }) => run.trail(kind, name)) ?? []
    this.#stage?.trails(trails('attained'), trails('command'))
  }

  /** Everything again: another scene, another run. */
  refresh(): void {
    this.grown()
    this.#showGhost()
    this.jogged(this.#jogged)
    this.update()
  }

  /** The cursor has moved; called inside an animation frame. */
  update(): void {
    if (!this.#scene) return
    const time = this.#cursor.time
    this.#run?.bodies(time, this.#poses, this.#visible)
    this.#stage?.show(this.#poses, this.#visible)
    this.#stage?.collisions(contactsAt(this.#run?.contacts ?? [], this.#scene, time))
    this.#stage?.trailWindows(this.#moves.map(moves => pathWindow(this.#look.path, time, moves)))
  }

  draw(): void {
    this.#stage?.draw()
  }

  #showGhost(): void {
    this.#stage?.ghost(this.ghostPoses)
  }
}

/** Poses of the description, parents first. */
function restAt(scene: SceneDescription, poses: Float32Array, visible: Uint8Array): void {
  scene.bodies.forEach((body, at) => {
    const parent = body.parent >= 0 ? poseAt(poses, body.parent) : null
    poses.set(parent ? compose(parent, body.pose) : body.pose, 7 * at)
    visible[at] = body.visible ? 1 : 0
  })
}

function poseAt(poses: Float32Array, body: number): Pose {
  const at = (k: number) => poses[7 * body + k] ?? 0
  return [at(0), at(1), at(2), at(3), at(4), at(5), at(6)]
}

async function fetchMesh(address: string): Promise<ArrayBuffer> {
  const answer = await ask(`/mesh/${address}.glb`)
  if (!answer.ok) throw new Error(`the server answered ${answer.status}`)
  return answer.arrayBuffer()
}
