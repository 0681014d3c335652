/** Everything that is in the picture, as one three.js scene; knows no canvas. */
import { Box3, Scene, Vector3 } from 'three'
import type { ShownContact } from '../run/contacts'
import { Backdrop } from './backdrop'
import { Bodies, standsStill } from './bodies'
import { cornersOf } from './camera_pose'
import { CollisionMarks } from './collision_marks'
import { Contacts } from './contacts'
import { Crosses } from './crosses'
import type { SceneDescription } from './description'
import { Floor } from './floor'
import type { Label } from './labels'
import { LightRig } from './light_rig'
import { Looks, type MeshSource } from './looks'
import { Materials } from './materials'
import type { Palette } from './palette'
import { type PointMark, PointMarks } from './point_marks'
import { SelectionMark } from './selection_mark'
import type { FrameKind, Lights, Shading, StageProblem } from './settings'
import { Shadow } from './shadow'
import { Tint, TintedArm } from './tinted_arm'
import { TrailLines } from './trail_lines'
import type { Words } from './words'

/** Share of the arm's reach beyond what is there that the first picture leaves room for. */
const REACH_SHOWN = 0.04

/** Which names of frames stay where they would overlap. */
const FRAME_RANKS: Record<FrameKind, number> = { tcp: 2, base: 3, world: 4, frame: 5, location: 6 }

export class Scenery {
  readonly scene = new Scene()
  readonly #rig = new LightRig()
  readonly shadow = new Shadow(this.#rig)
  readonly #materials: Materials
  readonly bodies: Bodies
  readonly #ghost: TintedArm
  readonly #jogged: TintedArm
  readonly #mark: SelectionMark
  readonly collisions: CollisionMarks
  readonly attained = new TrailLines(this.scene, 1)
  readonly command = new TrailLines(this.scene, 0.6)
  readonly #backdrop = new Backdrop(this.scene)
  readonly floor = new Floor(this.scene, this.#rig)
  readonly #contacts = new Contacts(this.scene)
  readonly crosses: Crosses
  readonly #points = new PointMarks(this.scene)
  readonly #looks: Looks
  readonly #labelPoints = new Map<string, Vector3>()
  readonly #extent = new Box3()
  #named = false
  #gone = false

  constructor(
    private readonly words: Words,
    palette: Palette,
  ) {
    // Nothing here hangs below anything that moves: world matrices are written, never worked out by three.js.
    this.scene.matrixWorldAutoUpdate = false
    this.#looks = new Looks(words)
    this.#materials = new Materials(this.#rig, palette)
    this.bodies = new Bodies(this.scene, this.#materials)
    this.#ghost = new TintedArm(this.scene, this.bodies, new Tint(0.3, 5, 'beside'))
    this.#jogged = new TintedArm(this.scene, this.bodies, new Tint(0.45, 6, 'beside'))
    this.#mark = new SelectionMark(this.scene, this.bodies, new Tint(0.2, 7, 'upon'))
    this.collisions = new CollisionMarks(this.scene, this.bodies, new Tint(0.55, 8, 'upon'))
    this.crosses = new Crosses(this.scene, this.bodies)
    this.setPalette(palette)
  }

  /** `changed` is called whenever a mesh has come or failed. */
  load(scene: SceneDescription, meshes: MeshSource, changed: () => void): void {
    this.bodies.load(scene, this.#looks)
    this.#extent.min.set(...scene.extent.min)
    this.#extent.max.set(...scene.extent.max)
    this.#mark.set(null)
    this.collisions.set([])
    this.crosses.load(scene.frames)
    this.#formed()
    this.#looks.fetch(scene.bodies, meshes, () => {
      if (this.#gone) return
      this.bodies.refresh(this.#looks)
      this.#mark.set(this.#mark.body)
      this.#formed()
      changed()
    })
  }

  /** What is there always, and samples of what cells bring. */
  samples(): readonly Scene[] {
    return [this.scene, new Scene().add(...this.#materials.samples())]
  }

  get problems(): readonly StageProblem[] {
    return this.#looks.problems(this.bodies.list)
  }

  /** Whether the picture is different from before. */
  show(poses: Float32Array, visible: Uint8Array): boolean {
    if (!this.bodies.show(poses, visible)) return false
    this.#moved()
    return true
  }

  ghost(poses: Float32Array | null): void {
    this.#ghost.show(poses)
  }

  jogged(poses: Float32Array | null): void {
    this.#jogged.show(poses)
  }

  /** Mark points of a program. */
  setPoints(points: readonly PointMark[]): void {
    this.#points.set(points)
  }

  select(body: number | null): void {
    this.#mark.set(body)
  }

  /** Show these collisions; whether the picture is different then. */
  setCollisions(contacts: readonly ShownContact[]): boolean {
    if (areSame(contacts, this.collisions.shown)) return false
    this.collisions.set(contacts)
    return true
  }

  setOpacity(body: number, opacity: number): void {
    this.bodies.setOpacity(body, opacity)
    this.shadow.touch()
  }

  setHidden(body: number, hidden: boolean): void {
    this.bodies.setHidden(body, hidden)
    this.#moved()
  }

  get lights(): Lights {
    return this.#rig.lights
  }

  setLights(lights: Lights): void {
    this.#rig.lights = lights
    this.#coverShadows()
  }

  /** Whether the picture is different then. */
  setShadows(on: boolean): boolean {
    if (on === this.shadow.on) return false
    this.shadow.on = on
    return true
  }

  get shading(): Shading {
    return this.#materials.shading
  }

  setShading(shading: Shading): void {
    this.#materials.setShading(shading)
    this.bodies.dress()
    this.shadow.touch()
  }

  setPalette(palette: Palette): void {
    this.#materials.setPalette(palette)
    this.bodies.dress()
    this.#backdrop.palette = palette
    this.floor.palette = palette
    this.attained.colour = palette.attained
    this.command.colour = palette.command
    this.#ghost.tint.colour = palette.ghost
    this.#jogged.tint.colour = palette.jogged
    this.#mark.tint.colour = palette.accent
    this.collisions.colour = palette.collision
    this.#points.setColours(palette.jogged, palette.accent)
  }

  /** Names beside coordinate systems. */
  setNamed(named: boolean): void {
    this.#named = named
  }

  /** All that is to be named in a viewport. Points go on moving with their bodies. */
  labels(): Label[] {
    this.#labelPoints.clear()
    const problems = this.problems.map(({ body, file }) => ({
      text: this.words.missingMesh(file.slice(file.lastIndexOf('/') + 1)),
      kind: 'problem' as const,
      rank: 0,
      point: this.#point(`body ${this.bodies.list.findIndex(({ name }) => name === body)}`),
    }))
    const selected = this.#mark.body === null ? undefined : this.bodies.list[this.#mark.body]
    const selection = selected
      ? [
          {
            text: selected.name,
            kind: 'selection' as const,
            rank: 1,
            point: this.#point(`body ${this.#mark.body}`),
          },
        ]
      : []
    const frames = this.#named
      ? this.crosses.shown.map(({ mark }, k) => ({
          text: mark.name,
          kind: 'frame' as const,
          rank: FRAME_RANKS[mark.kind],
          point: this.#point(`frame ${k}`),
        }))
      : []
    this.#movePoints()
    const points = this.#points.shown.map(({ name, point, selected }) => ({
      text: name,
      kind: selected ? ('selection' as const) : ('frame' as const),
      rank: selected ? 1 : 2,
      point,
    }))
    const collisions = this.collisions.shown.map(({ text, point }) => ({
      text,
      kind: 'problem' as const,
      rank: 0,
      point,
    }))
    return [...problems, ...collisions, ...selection, ...points, ...frames]
  }

  /** What all views show at first: everything there is now, and some of the room that the arm reaches. */
  homePoints(): Vector3[] {
    const box = this.bodies.box()
    if (box.isEmpty()) return cornersOf(this.#extent)
    const room = box.clone()
    room.min.min(box.min.clone().lerp(this.#extent.min, REACH_SHOWN))
    room.max.max(box.max.clone().lerp(this.#extent.max, REACH_SHOWN))
    return [...this.bodies.outline(), ...facesOf(room)]
  }

  /** Points that reach as far as a body, or all that is in the picture. */
  points(body: number | null): Vector3[] {
    const own = body === null ? [] : this.bodies.outlineOf(body)
    return own.length > 0 ? own : this.bodies.outline()
  }

  get selected(): number | null {
    return this.#mark.body
  }

  dispose(): void {
    this.#gone = true
    this.#looks.keep(new Set())
    for (const part of [
      this.bodies,
      this.#materials,
      this.shadow,
      this.attained,
      this.command,
      this.#backdrop,
      this.floor,
      this.#contacts,
      this.crosses,
      this.#points,
      this.collisions,
      this.#ghost.tint,
      this.#jogged.tint,
      this.#mark.tint,
    ]) {
      part.dispose()
    }
  }

  /** Forms have changed: what is made of them follows. */
  #formed(): void {
    this.#ghost.refresh()
    this.#jogged.refresh()
    this.collisions.refresh()
    const standing = this.bodies.list.flatMap((body, i) => (standsStill(body) ? [this.bodies.boxOf(i)] : []))
    const all = standing.reduce((sum, box) => sum.union(box), new Box3())
    this.floor.put(all, this.bodies.box())
    this.#contacts.put(this.bodies.footprints(this.floor.height), this.floor.height)
    this.#coverShadows()
    this.#moved()
  }

  /** Shadows are thrown by all there is, wherever the arm reaches. */
  #coverShadows(): void {
    this.shadow.cover(this.#extent.clone().union(this.bodies.box()))
  }

  #moved(): void {
    this.shadow.touch()
    this.crosses.update()
    this.#mark.update()
    this.collisions.update()
    this.#movePoints()
  }

  #point(key: string): Vector3 {
    const point = this.#labelPoints.get(key) ?? new Vector3()
    this.#labelPoints.set(key, point)
    return point
  }

  #movePoints(): void {
    for (const [key, point] of this.#labelPoints) {
      const [sort, index] = key.split(' ')
      const matrix =
        sort === 'body' ? this.bodies.matrix(Number(index)) : this.crosses.shown[Number(index)]?.matrix
      if (matrix) point.setFromMatrixPosition(matrix)
    }
  }
}

/** Whether the same collisions are meant: each is known by its words and its place. */
function areSame(some: readonly ShownContact[], others: readonly ShownContact[]): boolean {
  const key = ({ text, place, bodies }: ShownContact) => [text, ...place, ...bodies].join('|')
  return some.length === others.length && some.every((one, k) => key(one) === key(others[k] as ShownContact))
}

/** The middles of the six faces of a box. */
function facesOf({ min, max }: Box3): Vector3[] {
  const middle = min.clone().lerp(max, 0.5)
  return [min, max].flatMap(({ x, y, z }) => [
    middle.clone().setX(x),
    middle.clone().setY(y),
    middle.clone().setZ(z),
  ])
}
