/** The shadow map: how far the key light sees, drawn anew when something has moved. One map serves all viewports. */
import {
  type Box3,
  DepthTexture,
  DoubleSide,
  LessEqualCompare,
  LinearFilter,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  RedFormat,
  Scene,
  UnsignedShortType,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three'
import { cornersOf } from './camera_pose'
import type { LightRig } from './light_rig'
import { tier } from './tier'

/** The layer of what throws shadows. */
export const CASTERS = 1

/** Samples along each edge of the map. */
const SIZE = { none: 1, soft: 768, full: 2048 } as const

/** Room about the box that throws shadows [m]. */
const MARGIN = 0.05

export class Shadow {
  readonly #camera = new OrthographicCamera()
  readonly #material = new MeshBasicMaterial({
    side: DoubleSide,
    colorWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 1.5,
    polygonOffsetUnits: 2,
  })
  #target: WebGLRenderTarget | null = null
  #on = false
  #stale = true

  constructor(private readonly rig: LightRig) {
    this.#camera.matrixWorldAutoUpdate = false
    this.#camera.layers.set(CASTERS)
  }

  get on(): boolean {
    return this.#on
  }

  set on(on: boolean) {
    this.#on = on
    this.rig.uniforms.shadowStep.value = on ? 1 / SIZE[tier()] : 0
    this.touch()
  }

  /** What throws shadows has moved, or the light has. */
  touch(): void {
    this.#stale = true
  }

  /** Shadows are thrown by what is in this box of W [m]. */
  cover(box: Box3): void {
    const { direction } = this.rig
    const right = new Vector3(-direction.y, direction.x, 0)
    if (right.lengthSq() < 1e-6) right.set(1, 0, 0)
    right.normalize()
    const up = direction.clone().cross(right)
    const corners = cornersOf(box)
    const span = (axis: Vector3) => {
      const places = corners.map(corner => corner.dot(axis))
      return [Math.min(...places) - MARGIN, Math.max(...places) + MARGIN] as const
    }
    const [across, along, depth] = [span(right), span(up), span(direction)]
    const camera = this.#camera
    Object.assign(camera, { left: across[0], right: across[1], bottom: along[0], top: along[1] })
    // It looks against the direction to the light from the origin: what is nearer to the light has less depth.
    Object.assign(camera, { near: -depth[1], far: -depth[0] })
    camera.updateProjectionMatrix()
    camera.matrixWorld.makeBasis(right, up, direction)
    camera.matrixWorldInverse.copy(camera.matrixWorld).invert()
    // From -1 … 1 to the 0 … 1 of a texture.
    this.rig.uniforms.shadowMatrix.value
      .makeScale(0.5, 0.5, 0.5)
      .setPosition(0.5, 0.5, 0.5)
      .multiply(camera.projectionMatrix)
      .multiply(camera.matrixWorldInverse)
    this.touch()
  }

  /** Have the graphics ready for the map. */
  prepare(renderer: WebGLRenderer): void {
    const sample = new Scene()
    sample.add(new Mesh(undefined, this.#material))
    renderer.setRenderTarget(this.#made())
    renderer.compile(sample, this.#camera)
    renderer.setRenderTarget(null)
  }

  /** Bring the map up to date; `bare` has nothing but bodies lit by the rig. */
  update(renderer: WebGLRenderer, scene: Scene): void {
    if (!this.#on || !this.#stale) return
    this.#stale = false
    const target = this.#made()
    const before = scene.overrideMaterial
    scene.overrideMaterial = this.#material
    this.rig.uniforms.shadowMap.value = null
    renderer.setRenderTarget(target)
    renderer.render(scene, this.#camera)
    renderer.setRenderTarget(null)
    scene.overrideMaterial = before
    this.rig.uniforms.shadowMap.value = target.depthTexture
  }

  dispose(): void {
    this.#target?.dispose()
    this.#material.dispose()
  }

  #made(): WebGLRenderTarget {
    if (this.#target) return this.#target
    const size = SIZE[tier()]
    const depthTexture = new DepthTexture(size, size, UnsignedShortType)
    depthTexture.compareFunction = LessEqualCompare
    depthTexture.minFilter = LinearFilter
    depthTexture.magFilter = LinearFilter
    this.#target = new WebGLRenderTarget(size, size, { format: RedFormat, depthTexture })
    return this.#target
  }
}
