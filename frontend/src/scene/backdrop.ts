/** The background of a viewport: an even change of colour from top to bottom. */
import { BufferAttribute, BufferGeometry, Color, Mesh, type Object3D, ShaderMaterial } from 'three'
import type { Palette } from './palette'

// Colours arrive as they are shown and are mixed as the eye sees them: no work for each pixel.
const VERTEX = /* glsl */ `
uniform vec3 top;
uniform vec3 bottom;
varying vec3 colour;
void main() {
  colour = mix(bottom, top, 0.5 + 0.5 * position.y);
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`

const FRAGMENT = /* glsl */ `
varying vec3 colour;
void main() {
  gl_FragColor = vec4(colour, 1.0);
}`

export class Backdrop {
  readonly #mesh: Mesh<BufferGeometry, ShaderMaterial>

  constructor(private readonly parent: Object3D) {
    const geometry = new BufferGeometry()
    // One triangle that covers the viewport.
    geometry.setAttribute(
      'position',
      new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3),
    )
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { top: { value: new Color() }, bottom: { value: new Color() } },
      depthTest: false,
      depthWrite: false,
    })
    this.#mesh = new Mesh(geometry, material)
    this.#mesh.frustumCulled = false
    this.#mesh.renderOrder = -10
    parent.add(this.#mesh)
  }

  set palette({ top, bottom }: Palette) {
    const { uniforms } = this.#mesh.material
    if (uniforms.top) uniforms.top.value = top.clone().convertLinearToSRGB()
    if (uniforms.bottom) uniforms.bottom.value = bottom.clone().convertLinearToSRGB()
  }

  dispose(): void {
    this.parent.remove(this.#mesh)
    this.#mesh.geometry.dispose()
    this.#mesh.material.dispose()
  }
}
