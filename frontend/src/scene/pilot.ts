/** Moves the camera of one viewport: what gestures, keys and buttons ask for, done to its pose. */
import { Plane, Ray, Vector3 } from 'three'
import { basisOf, DIRECTIONS, lookFrom, orbit, pan, zoom } from './camera_pose'
import { Glide } from './glide'
import type { CameraPose, Preset, ViewState } from './settings'
import { ViewCamera } from './view_camera'

/** What the buttons at the top left of a viewport cover [CSS px], and the share of its height left to them at most. */
const BUTTONS = { width: 156, height: 34 }
const MOST_COVERED = 0.2

export interface PilotContext {
  readonly reducedMotion: boolean
  /** Where a line of sight meets the scene. */
  hit(ray: Ray): Vector3 | null
  /** Height of the floor in W [m]. */
  floor(): number
}

export class Pilot {
  readonly view = new ViewCamera()
  readonly #anchor = new Vector3()
  readonly #ray = new Ray()
  #preset: Preset
  #width = 1
  #height = 1
  #glide: Glide | null = null
  /** What it shows all of, as long as the user has not moved it. */
  #home: readonly Vector3[] | null = null

  /** `moved` is told of every new pose, `renamed` of another direction or projection. */
  constructor(
    readonly id: Exclude<Preset, 'custom'>,
    private readonly context: PilotContext,
    private readonly moved: () => void,
    private readonly renamed: () => void,
  ) {
    this.#preset = id
    const [azimuth, elevation, projection] = DIRECTIONS[id]
    this.view.set(lookFrom(this.view.pose, azimuth, elevation), projection)
  }

  get preset(): Preset {
    return this.#preset
  }

  get state(): ViewState {
    return { ...this.view.pose, preset: this.#preset, projection: this.view.projection }
  }

  /** Size of the picture [CSS px]. */
  resize(width: number, height: number): void {
    this.#width = width
    this.#height = height
    this.view.setAspect(width / height)
    if (this.#home) this.home(this.#home)
  }

  restore({ preset, projection, ...pose }: ViewState): void {
    this.#glide = null
    this.#preset = preset
    this.#set(pose, projection)
    this.renamed()
  }

  /** Look from a named direction at what is in the middle now. */
  look(preset: Exclude<Preset, 'custom'>): void {
    const [azimuth, elevation, projection] = DIRECTIONS[preset]
    this.#preset = preset
    this.view.set(this.view.pose, projection)
    this.#glideTo(lookFrom(this.view.pose, azimuth, elevation))
    this.renamed()
  }

  /** Back to its own direction, with all points in sight. */
  home(points: readonly Vector3[]): void {
    const [azimuth, elevation, projection] = DIRECTIONS[this.id]
    this.#glide = null
    this.#preset = this.id
    this.view.set(lookFrom(this.view.pose, azimuth, elevation), projection)
    if (points.length > 0) this.view.set(this.#fitted(points))
    this.#home = points
    this.renamed()
    this.moved()
  }

  /** There is more to show: do so, unless the user has moved the view. */
  grown(points: readonly Vector3[]): void {
    if (this.#home) this.home(points)
  }

  switchProjection(): void {
    this.#set(this.view.pose, this.view.projection === 'perspective' ? 'parallel' : 'perspective')
    this.renamed()
  }

  /** One thing in the middle, as large as can be. */
  fit(points: readonly Vector3[]): void {
    if (points.length > 0) this.#glideTo(this.view.fitted(points))
  }

  /** All there is, and nothing of it below the buttons. */
  fitAll(points: readonly Vector3[]): void {
    if (points.length > 0) this.#glideTo(this.#fitted(points))
  }

  /** Turn about the anchor [rad]. */
  turn(azimuth: number, elevation: number): void {
    this.#glide = null
    this.#set(orbit(this.view.pose, this.#anchor, azimuth, elevation, this.context.floor()))
    if (this.#preset === 'perspective' || this.#preset === 'custom') return
    this.#preset = 'custom'
    this.renamed()
  }

  /** Move the anchor by shares of the height of the picture, right and up. */
  move(right: number, up: number): void {
    this.#glide = null
    // Never quite still, also when the anchor is very near or behind the eye.
    const depth = Math.max(this.view.depth(this.#anchor), 0.05 * this.view.pose.distance)
    this.#set(pan(this.view.pose, right, up, depth))
  }

  /** Come nearer to the anchor (factor < 1) or go away from it. */
  zoom(factor: number): void {
    this.#glide = null
    this.#set(zoom(this.view.pose, this.#anchor, factor))
  }

  anchorInMiddle(): void {
    this.#anchor.set(...this.view.pose.target)
  }

  /** The anchor is what lies at a place [CSS px]: a point of a body, else of the plane through the target. */
  anchorAt(x: number, y: number): void {
    const ray = this.sight(x, y)
    const hit = this.context.hit(ray)
    if (hit) {
      this.#anchor.copy(hit)
      return
    }
    const { pose } = this.view
    const target = new Vector3(...pose.target)
    const plane = new Plane().setFromNormalAndCoplanarPoint(basisOf(pose).back, target)
    if (!ray.intersectPlane(plane, this.#anchor)) this.#anchor.copy(target)
  }

  /** The line of sight through a place [CSS px]. */
  sight(x: number, y: number): Ray {
    return this.view.ray((2 * x) / this.#width - 1, 1 - (2 * y) / this.#height, this.#ray)
  }

  /** Go on gliding; true while there is more to come. */
  step(now: number): boolean {
    if (!this.#glide) return false
    const { pose, over } = this.#glide.at(now)
    if (over) this.#glide = null
    this.#set(pose)
    return !over
  }

  /** All points in sight, as large as can be; where one would lie below the buttons, their rows stay free. */
  #fitted(points: readonly Vector3[]): CameraPose {
    const pose = this.view.fitted(points)
    const before = this.view.pose
    this.view.set(pose)
    const [right, low] = [(2 * BUTTONS.width) / this.#width - 1, 1 - (2 * BUTTONS.height) / this.#height]
    const isCovered = points.some(point => {
      const { x, y } = this.view.project(point, new Vector3())
      return x < right && y > low
    })
    this.view.set(before)
    return isCovered ? this.view.fitted(points, Math.min(BUTTONS.height / this.#height, MOST_COVERED)) : pose
  }

  #glideTo(pose: CameraPose): void {
    if (this.context.reducedMotion) this.#set(pose)
    else this.#glide = new Glide(this.view.pose, pose)
    this.#home = null
    this.moved()
  }

  #set(pose: CameraPose, projection = this.view.projection): void {
    this.#home = null
    this.view.set(pose, projection)
    this.moved()
  }
}
