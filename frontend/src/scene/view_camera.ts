/** The camera of one viewport: a pose and a projection made into the matrices that three.js draws with. */
import { type Camera, MathUtils, OrthographicCamera, PerspectiveCamera, type Ray, Vector3 } from 'three'
import { basisOf, depthOf, eyeOf, FIELD_OF_VIEW, fitted, HALF_HEIGHT } from './camera_pose'
import type { CameraPose, Projection } from './settings'

/** How far before and behind the target parallel projection sees [m]. */
const REACH = 100

export class ViewCamera {
  readonly #perspective = new PerspectiveCamera(MathUtils.radToDeg(FIELD_OF_VIEW), 1, 0.01, REACH)
  readonly #parallel = new OrthographicCamera(-1, 1, 1, -1, -REACH, REACH)
  readonly #point = new Vector3()
  #pose: CameraPose = { target: [0, 0, 0], azimuth: 0, elevation: 0, distance: 3 }
  #projection: Projection = 'perspective'
  #aspect = 1

  constructor() {
    for (const camera of [this.#perspective, this.#parallel]) camera.matrixWorldAutoUpdate = false
    this.#update()
  }

  get camera(): Camera {
    return this.#projection === 'perspective' ? this.#perspective : this.#parallel
  }

  get pose(): CameraPose {
    return this.#pose
  }

  get projection(): Projection {
    return this.#projection
  }

  get aspect(): number {
    return this.#aspect
  }

  set(pose: CameraPose, projection: Projection = this.#projection): void {
    this.#pose = pose
    this.#projection = projection
    this.#update()
  }

  setAspect(aspect: number): void {
    if (aspect === this.#aspect) return
    this.#aspect = aspect
    this.#update()
  }

  /** The pose that shows all points from the present direction, below the `covered` share of the picture. */
  fitted(points: readonly Vector3[], covered = 0): CameraPose {
    return fitted(this.#pose, points, this.#aspect, this.#projection, covered)
  }

  /** Place in the picture: x and y from -1 (left, bottom) to 1; z in -1 … 1 when it is in front. */
  project(point: Vector3, out: Vector3): Vector3 {
    return out.copy(point).project(this.camera)
  }

  /** The line of sight through a place in the picture (-1 … 1 each). */
  ray(x: number, y: number, out: Ray): Ray {
    const { right, up, back } = basisOf(this.#pose)
    const half = HALF_HEIGHT * this.#pose.distance
    const through = this.#point
      .set(...this.#pose.target)
      .addScaledVector(right, x * half * this.#aspect)
      .addScaledVector(up, y * half)
    if (this.#projection === 'perspective') {
      out.origin.copy(eyeOf(this.#pose))
      out.direction.copy(through).sub(out.origin).normalize()
    } else {
      out.origin.copy(through).addScaledVector(back, REACH)
      out.direction.copy(back).negate()
    }
    return out
  }

  /** Depth at which panning moves a point with the pointer [m]. */
  depth(point: Vector3): number {
    return this.#projection === 'perspective' ? depthOf(this.#pose, point) : this.#pose.distance
  }

  #update(): void {
    const { right, up, back } = basisOf(this.#pose)
    const eye = eyeOf(this.#pose)
    const { distance } = this.#pose
    const half = HALF_HEIGHT * distance
    this.#perspective.aspect = this.#aspect
    this.#perspective.near = MathUtils.clamp(distance * 0.02, 0.002, 0.1)
    this.#perspective.far = distance + REACH
    this.#parallel.left = -half * this.#aspect
    this.#parallel.right = half * this.#aspect
    this.#parallel.top = half
    this.#parallel.bottom = -half
    for (const camera of [this.#perspective, this.#parallel]) {
      camera.updateProjectionMatrix()
      camera.matrixWorld.makeBasis(right, up, back).setPosition(eye)
      camera.matrixWorldInverse.copy(camera.matrixWorld).invert()
    }
  }
}
