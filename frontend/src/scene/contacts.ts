/** Soft dark patches on the floor below what stands on it. */
import {
  type Box3,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  type Object3D,
  PlaneGeometry,
  ShaderMaterial,
} from 'three'

/** Width of the soft rim [m]. */
const RIM = 0.14

const VERTEX = /* glsl */ `
varying vec2 place;
varying vec2 extent;
void main() {
  extent = vec2(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz));
  place = position.xy * extent;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * instanceMatrix * vec4(position, 1.0);
}`

const FRAGMENT = /* glsl */ `
varying vec2 place;
varying vec2 extent;
void main() {
  float outside = length(max(abs(place) - extent + ${(2 * RIM).toFixed(3)}, 0.0)) / ${(2 * RIM).toFixed(3)};
  float dark = 1.0 - smoothstep(0.0, 1.0, outside);
  gl_FragColor = vec4(0.0, 0.0, 0.0, 0.26 * dark);
}`

export class Contacts {
  readonly #mesh: InstancedMesh<PlaneGeometry, ShaderMaterial>

  constructor(private readonly parent: Object3D) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
    })
    this.#mesh = new InstancedMesh(new PlaneGeometry(2, 2), material, 0)
    this.#mesh.frustumCulled = false
    this.#mesh.renderOrder = -1
    parent.add(this.#mesh)
  }

  /** Patches below these boxes on a floor at this height [m]. */
  put(standing: readonly Box3[], floor: number): void {
    const matrices = new InstancedBufferAttribute(new Float32Array(16 * standing.length), 16)
    standing.forEach(({ min, max }, k) => {
      const [x, y] = [(max.x - min.x) / 2 + RIM, (max.y - min.y) / 2 + RIM]
      new Matrix4()
        .makeScale(x, y, 1)
        .setPosition((min.x + max.x) / 2, (min.y + max.y) / 2, floor)
        .toArray(matrices.array, 16 * k)
    })
    this.#mesh.instanceMatrix = matrices
    this.#mesh.count = standing.length
    this.#mesh.visible = standing.length > 0
  }

  dispose(): void {
    this.parent.remove(this.#mesh)
    this.#mesh.geometry.dispose()
    this.#mesh.material.dispose()
    this.#mesh.dispose()
  }
}
