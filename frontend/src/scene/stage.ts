/** The 3-D stage: a cell in one to four viewports on one canvas. Knows nothing of runs or React. */
import { Box3, Vector3 } from 'three'
import type { ShownContact } from '../run/contacts'
import { cornersOf } from './camera_pose'
import type { Pose, SceneDescription, Vector3 as Triple } from './description'
import { Listeners } from './listeners'
import type { MeshSource } from './looks'
import { Overlay } from './overlay'
import { paletteOf } from './palette'
import type { PointMark } from './point_marks'
import { Scenery } from './scenery'
import { Screen } from './screen'
import type {
  FrameKind,
  Layout,
  Lights,
  PathWindow,
  PickListener,
  Point,
  Preset,
  Shading,
  StageOptions,
  StageProblem,
  StageState,
  StageStats,
  Theme,
  Trail,
} from './settings'
import { tier } from './tier'
import { words } from './words'
import './stage.css'

export type { MeshSource } from './looks'
export type { StageOptions } from './settings'

/** So far around a place a view shows when it is framed [m]. */
const AROUND = 0.2

export class Stage {
  readonly #scenery: Scenery
  readonly #overlay: Overlay
  readonly #screen: Screen
  readonly #troubled = new Listeners<[]>()
  #project: string | null = null
  #restored = false

  constructor(
    private readonly host: HTMLElement,
    options: StageOptions = {},
  ) {
    const texts = { ...words, ...options.messages }
    host.classList.add('stage')
    this.#scenery = new Scenery(texts, paletteOf(options.theme ?? 'light', host))
    this.#overlay = new Overlay(host, texts)
    this.#screen = new Screen(host, this.#scenery, this.#overlay, texts, options.reducedMotion ?? false)
  }

  /** Whether this browser can draw at all. Without it a message is shown and every method is harmless. */
  static supported(): boolean {
    return tier() !== 'none'
  }

  /** Show a cell. Cameras stay where they are unless it is the first one or one of another project. */
  load(scene: SceneDescription, meshes: MeshSource): void {
    this.#scenery.load(scene, meshes, () => {
      this.#screen.reformed()
      this.#troubled.tell()
    })
    // Cameras that were brought back before the first cell are meant for it.
    if (scene.project !== this.#project && !(this.#project === null && this.#restored)) this.home()
    this.#project = scene.project
    this.#screen.relabel()
    this.#troubled.tell()
  }

  /** Show bodies at these world poses (7 numbers each: x y z w qx qy qz); `visible` 1 or 0 for each. Not kept. */
  show(poses: Float32Array, visible: Uint8Array): void {
    if (this.#scenery.show(poses, visible)) this.#screen.redraw()
  }

  layout(kind: Layout): void {
    this.#screen.layout = kind
  }

  /** Layout and cameras, to be kept with the project or for undo. */
  state(): StageState {
    return this.#screen.state
  }

  restore(state: StageState): void {
    this.#restored = true
    this.#screen.restore(state)
  }

  /** Called after the user has changed a camera, projection or direction of view. */
  onViewChange(listener: () => void): () => void {
    return this.#screen.changed.add(listener)
  }

  /** The tool's path as it was and as it was wanted; null for none. Call again when a live run has grown. */
  trails(attained: readonly Trail[], command: readonly Trail[]): void {
    this.#scenery.attained.set(attained)
    this.#scenery.command.set(command)
    this.#screen.redraw()
  }

  /** How much of the paths is drawn, in the order of the paths. */
  trailWindows(windows: readonly PathWindow[]): void {
    const { attained, command } = this.#scenery
    const changed = [attained.setWindows(windows), command.setWindows(windows)]
    if (changed.includes(true)) this.#screen.redraw()
  }

  /** A second, transparent arm (links and tool) at these poses. Same layout as `show`. */
  ghost(poses: Float32Array | null): void {
    this.#scenery.ghost(poses)
    this.#screen.redraw()
  }

  /** A third arm, the one that is being jogged. */
  jogged(poses: Float32Array | null): void {
    this.#scenery.jogged(poses)
    this.#screen.redraw()
  }

  /** Veil the picture: it shows an older state than the text. */
  stale(on: boolean): void {
    this.#overlay.stale(on)
  }

  select(body: number | null): void {
    this.#scenery.select(body)
    this.#screen.relabel()
  }

  /** Show these collisions: their bodies red, a mark at the deepest point of each. */
  collisions(contacts: readonly ShownContact[]): void {
    if (this.#scenery.setCollisions(contacts)) this.#screen.relabel()
  }

  /** Bodies that are red, and the marks of collisions in W. */
  get colliding(): { readonly bodies: readonly number[]; readonly marks: readonly Triple[] } {
    const { red, shown } = this.#scenery.collisions
    return { bodies: red, marks: shown.map(({ place }) => place) }
  }

  /** Frame a place in every viewport, with what is around it. */
  frame([x, y, z]: Triple): void {
    const near = new Vector3(AROUND, AROUND, AROUND)
    const middle = new Vector3(x, y, z)
    const points = cornersOf(new Box3(middle.clone().sub(near), middle.clone().add(near)))
    for (const view of this.#screen.views) view.pilot.fit(points)
  }

  /** Mark points of a program, with their names. */
  points(points: readonly PointMark[]): void {
    this.#scenery.setPoints(points)
    this.#screen.relabel()
  }

  /** Opacity of a body, 0 … 1; 1 draws it as described. */
  setOpacity(body: number, opacity: number): void {
    this.#scenery.setOpacity(body, opacity)
    this.#screen.redraw()
  }

  /** Take a body out of the picture or back into it, whatever the run says. */
  setHidden(body: number, hidden: boolean): void {
    this.#scenery.setHidden(body, hidden)
    this.#screen.redraw()
  }

  /** Kinds of coordinate systems to draw. */
  frames(kinds: ReadonlySet<FrameKind>): void {
    this.#scenery.crosses.setKinds(kinds)
    this.#screen.relabel()
  }

  /** Names beside the coordinate systems. */
  labels(on: boolean): void {
    this.#scenery.setNamed(on)
    this.#screen.relabel()
  }

  get lights(): Lights {
    return this.#scenery.lights
  }

  setLights(lights: Lights): void {
    this.#scenery.setLights(lights)
    this.#screen.redraw()
  }

  /** Whether bodies throw shadows. */
  shadows(on: boolean): void {
    if (this.#scenery.setShadows(on)) this.#screen.redraw()
  }

  get shading(): Shading {
    return this.#scenery.shading
  }

  setShading(shading: Shading): void {
    this.#scenery.setShading(shading)
    this.#screen.redraw()
  }

  /** Colours are read from the style sheet anew, so the page must have changed before. */
  setTheme(theme: Theme): void {
    this.#scenery.setPalette(paletteOf(theme, this.host))
    this.#screen.redraw()
  }

  /** Fit the selected body, or all, into every viewport. */
  fit(): void {
    const points = this.#scenery.points(this.#scenery.selected)
    for (const view of this.#screen.views) view.pilot.fit(points)
  }

  /** Every viewport back to its own direction of view, all in sight. */
  home(): void {
    for (const view of this.#screen.views) view.pilot.home(this.#scenery.homePoints())
  }

  /** Turn the view that has the keyboard, or the first one, to a direction. */
  look(preset: Exclude<Preset, 'custom'>): void {
    const { shown } = this.#screen
    const view = shown.find(one => one.element.contains(document.activeElement)) ?? shown[0]
    view?.pilot.look(preset)
  }

  /** What is drawn, as a PNG image; null where nothing can be drawn. */
  async image(): Promise<Blob | null> {
    this.#screen.drawAll()
    const canvas = this.host.querySelector('canvas')
    return canvas ? new Promise(resolve => canvas.toBlob(resolve, 'image/png')) : null
  }

  /** Text twin of the picture for people who do not see it; at most once a second. */
  describe(text: string): void {
    this.#overlay.describe(text)
  }

  onPick(listener: PickListener): () => void {
    return this.#screen.picked.add(listener)
  }

  /** Called after each frame in which something was drawn. */
  onDrawn(listener: () => void): () => void {
    return this.#screen.drawn.add(listener)
  }

  /** Draw what has changed now; for callers that are inside an animation frame already. */
  draw(): void {
    this.#screen.draw()
  }

  /** Draw every view now, however long it takes. */
  drawAll(): void {
    this.#screen.drawAll()
  }

  stats(): StageStats {
    return this.#screen.stats()
  }

  get problems(): readonly StageProblem[] {
    return this.#scenery.problems
  }

  onProblems(listener: () => void): () => void {
    return this.#troubled.add(listener)
  }

  /** Where a point of W [m] lies in a viewport (index or id) [CSS px from its top left]; null when it is not shown. */
  project(view: number | string, point: Triple): Point | null {
    return this.#screen.view(view)?.project(new Vector3(...point)) ?? null
  }

  /** World pose in which a body is shown now. */
  pose(body: number): Pose | null {
    return this.#scenery.bodies.poseOf(body)
  }

  dispose(): void {
    this.#screen.dispose()
    this.#scenery.dispose()
    this.#overlay.remove()
    this.#troubled.clear()
    this.host.classList.remove('stage')
  }
}
