/** The bodies of a cell in the scene: where they are and which are seen. */
import { Box3, Matrix4, type Object3D, Quaternion, Vector3 } from 'three'
import { cornersOf } from './camera_pose'
import type { Body, BodyKind, Pose, SceneDescription } from './description'
import { Crowd, Figure, type Wardrobe } from './figure'
import { initialState } from './initial_state'
import type { Look } from './look'
import type { Looks } from './looks'
import type { Wearer } from './materials'

/** So many equal bodies are drawn in one go. */
const CROWD_FROM = 4

/** What is this near to the floor stands on it [m]. */
const FOOT = 0.02

const ARM: ReadonlySet<BodyKind> = new Set<BodyKind>(['base', 'link', 'cylinder', 'tool'])

/** Whether a body never moves: bases of robots and devices, and objects. */
export function standsStill({ kind, name }: Body): boolean {
  return kind === 'base' || kind === 'object' || (kind === 'device' && name.endsWith('/base'))
}

const ONE = new Vector3(1, 1, 1)

interface Cast {
  readonly figure: Figure
  readonly members: readonly number[]
  /** Missing for a figure that is drawn by itself. */
  readonly crowd?: Crowd
  readonly opacity: number
  readonly wearer: Wearer
}

export class Bodies {
  #bodies: readonly Body[] = []
  #looks: Look[] = []
  /** World pose of each body. */
  #matrices: Matrix4[] = []
  #cast: Cast[] = []
  #poses: Float32Array = new Float32Array(0)
  #visible: Uint8Array = new Uint8Array(0)
  #hidden: boolean[] = []
  #opacity: number[] = []
  readonly #position = new Vector3()
  readonly #quaternion = new Quaternion()

  constructor(
    private readonly parent: Object3D,
    private readonly wardrobe: Wardrobe,
  ) {}

  get list(): readonly Body[] {
    return this.#bodies
  }

  /** Take on the bodies of a scene, as they are at its start; what was hidden by hand stays so. */
  load(scene: SceneDescription, looks: Looks): void {
    const before = new Map(this.#bodies.map(({ name }, i) => [name, i]))
    const kept = <T>(values: readonly T[], fallback: T) =>
      scene.bodies.map(({ name }) => values[before.get(name) ?? -1] ?? fallback)
    this.#hidden = kept(this.#hidden, false)
    this.#opacity = kept(this.#opacity, 1)
    this.#bodies = scene.bodies
    this.#matrices = scene.bodies.map(() => new Matrix4())
    this.refresh(looks)
    const { poses, visible } = initialState(scene)
    this.#poses = new Float32Array(0)
    this.show(poses, visible)
  }

  /** Meshes have come: look again. */
  refresh(looks: Looks): void {
    this.#looks = this.#bodies.map(({ shapes }) => looks.of(shapes))
    looks.keep(new Set(this.#looks))
    this.#recast()
  }

  /** Seven numbers per body; whether anything is different from before. */
  show(poses: Float32Array, visible: Uint8Array): boolean {
    const count = this.#bodies.length
    if (poses.length < 7 * count || visible.length < count) return false
    if (same(this.#poses, poses, 7 * count) && same(this.#visible, visible, count)) return false
    this.#poses = copied(this.#poses, poses, 7 * count)
    this.#visible = copied(this.#visible, visible, count)
    for (let i = 0; i < count; i++) this.read(poses, i, this.#matrices[i])
    this.#place()
    return true
  }

  /** The pose of body `i` among poses, as a matrix. */
  read(poses: Float32Array, i: number, out = new Matrix4()): Matrix4 {
    const at = 7 * i
    this.#position.fromArray(poses, at)
    // Here the scalar comes first, in three.js it comes last.
    this.#quaternion.set(poses[at + 4] ?? 0, poses[at + 5] ?? 0, poses[at + 6] ?? 0, poses[at + 3] ?? 1)
    return out.compose(this.#position, this.#quaternion, ONE)
  }

  matrix(body: number): Matrix4 | undefined {
    return this.#matrices[body]
  }

  look(body: number): Look | undefined {
    return this.#looks[body]
  }

  /** Whether a body is in the picture. */
  shown(body: number): boolean {
    return this.#visible[body] === 1 && !this.#hidden[body]
  }

  /** Whether a line of sight can hit a body. */
  solid(body: number): boolean {
    return this.shown(body) && this.#opacity[body] !== 0
  }

  /** World pose of a body as it was shown last; null when there is no such body. */
  poseOf(body: number): Pose | null {
    if (!(body in this.#bodies)) return null
    const [x = 0, y = 0, z = 0, qw = 1, qx = 0, qy = 0, qz = 0] = this.#poses.subarray(7 * body)
    return [x, y, z, qw, qx, qy, qz]
  }

  setHidden(body: number, hidden: boolean): void {
    if (!(body in this.#hidden) || hidden === this.#hidden[body]) return
    this.#hidden[body] = hidden
    this.#place()
  }

  setOpacity(body: number, opacity: number): void {
    if (!(body in this.#opacity)) return
    // Steps keep the number of materials small.
    const step = Math.round(Math.min(Math.max(opacity, 0), 1) * 20) / 20
    if (step === this.#opacity[body]) return
    this.#opacity[body] = step
    this.#recast()
    this.#place()
  }

  /** After the wardrobe has changed. */
  dress(): void {
    for (const { figure, opacity, wearer } of this.#cast) figure.dress(this.wardrobe, opacity, wearer)
  }

  /** Box about a body in W; empty when it has no form. */
  boxOf(body: number): Box3 {
    return new Box3().setFromPoints(this.cornersOf(body))
  }

  /** Boxes in W about the feet of all that stands on a floor at this height [m] and stays there. */
  footprints(floor: number): Box3[] {
    const point = new Vector3()
    return this.#bodies.flatMap((body, i) => {
      const [look, matrix] = [this.#looks[i], this.#matrices[i]]
      const feet = new Box3()
      if (!look || !matrix || !standsStill(body)) return []
      for (const geometry of look.surfaces()) {
        const corners = geometry.getAttribute('position')
        for (let k = 0; k < corners.count; k++) {
          point.fromBufferAttribute(corners, k).applyMatrix4(matrix)
          if (point.z < floor + FOOT) feet.expandByPoint(point)
        }
      }
      return feet.isEmpty() ? [] : [feet]
    })
  }

  /** Corners in W of the box about one body, in whose frame it is. */
  cornersOf(body: number): Vector3[] {
    const [look, matrix] = [this.#looks[body], this.#matrices[body]]
    return look && matrix ? cornersOf(look.box).map(corner => corner.applyMatrix4(matrix)) : []
  }

  /** Points in W that reach as far as a body does. */
  outlineOf(body: number): Vector3[] {
    const [look, matrix] = [this.#looks[body], this.#matrices[body]]
    return look && matrix ? look.outline.map(point => point.clone().applyMatrix4(matrix)) : []
  }

  /** Those of all bodies that are in the picture. */
  outline(): Vector3[] {
    return this.#bodies.flatMap((_, i) => (this.shown(i) ? this.outlineOf(i) : []))
  }

  /** Box about all that is in the picture, in W. */
  box(): Box3 {
    return this.#bodies.reduce((box, _, i) => (this.shown(i) ? box.union(this.boxOf(i)) : box), new Box3())
  }

  dispose(): void {
    for (const { figure } of this.#cast) figure.removeFrom(this.parent)
    this.#cast = []
  }

  /** Decide which bodies are drawn together, and make the figures. */
  #recast(): void {
    this.dispose()
    const alike = new Map<Look, number[]>()
    const alone: number[] = []
    this.#looks.forEach((look, i) => {
      const arm = ARM.has(this.#bodies[i]?.kind ?? 'object')
      const plain = !arm && this.#opacity[i] === 1 && look.pieces.every(({ opacity }) => opacity === 1)
      if (plain) alike.set(look, [...(alike.get(look) ?? []), i])
      else alone.push(i)
    })
    for (const [look, members] of alike) {
      if (members.length < CROWD_FROM) {
        alone.push(...members)
        continue
      }
      const crowd = new Crowd(members.length)
      this.#cast.push({ figure: Figure.of(look, crowd), members, crowd, opacity: 1, wearer: 'thing' })
    }
    for (const i of alone) {
      const [look, matrix] = [this.#looks[i], this.#matrices[i]]
      if (!look || !matrix) continue
      const opacity = this.#opacity[i] ?? 1
      const wearer = ARM.has(this.#bodies[i]?.kind ?? 'object') ? 'arm' : 'thing'
      this.#cast.push({ figure: Figure.at(look, matrix), members: [i], opacity, wearer })
    }
    for (const { figure } of this.#cast) this.parent.add(figure.group)
    this.dress()
    this.#place()
  }

  /** Bring figures to where their bodies are. */
  #place(): void {
    for (const { figure, members, crowd } of this.#cast) {
      if (!crowd) {
        figure.group.visible = this.shown(members[0] ?? -1)
        continue
      }
      let count = 0
      for (const i of members) {
        const matrix = this.#matrices[i]
        if (matrix && this.shown(i)) crowd.place(count++, matrix)
      }
      crowd.setCount(count)
    }
  }
}

function same(a: ArrayLike<number>, b: ArrayLike<number>, count: number): boolean {
  if (a.length !== count) return false
  for (let k = 0; k < count; k++) if (a[k] !== b[k]) return false
  return true
}

function copied<T extends Float32Array | Uint8Array>(into: T, from: T, count: number): T {
  if (into.length !== count) return from.slice(0, count) as T
  into.set(from.subarray(0, count))
  return into
}
