/** The floor: a plane with lines each 100 mm and each metre that fades out, W's x and y axes and shadows upon it. */
import {
  type Box3,
  Color,
  DoubleSide,
  Mesh,
  type Object3D,
  PlaneGeometry,
  ShaderMaterial,
  Vector2,
} from 'three'
import { AXIS_COLOURS } from './crosses'
import { SHADOW } from './light_code'
import type { LightRig } from './light_rig'
import type { Palette } from './palette'

const VERTEX = /* glsl */ `
varying vec2 place;
varying float level;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xy;
  level = world.z;
  gl_Position = projectionMatrix * viewMatrix * world;
}`

// Colours arrive as they are shown. Lines keep one pixel of width; where a cell shrinks to few pixels its lines fade instead of flickering.
const FRAGMENT = /* glsl */ `
uniform vec3 grid;
uniform vec3 axisX;
uniform vec3 axisY;
uniform vec2 centre;
uniform float reach;
uniform float shade;
varying vec2 place;
varying float level;
${SHADOW}
float lines(vec2 p, vec2 width) {
  vec2 near = abs(fract(p - 0.5) - 0.5) / width;
  vec2 line = 1.0 - min(near, 1.0);
  line *= 1.0 - smoothstep(0.12, 0.4, width);
  return max(line.x, line.y);
}
void main() {
  vec2 width = fwidth(place);
  float fade = 1.0 - smoothstep(0.35, 1.0, length(place - centre) / reach);
  if (fade <= 0.0) discard;
  float fine = lines(place * 10.0, width * 10.0);
  float coarse = lines(place, width * 1.2);
  vec2 axis = 1.0 - min(abs(place) / (width * 1.4), 1.0);
  vec3 colour = grid;
  float alpha = max(max(0.20 * fine, 0.50 * coarse), 0.045);
  if (axis.y > 0.0) { colour = mix(colour, axisX, axis.y); alpha = max(alpha, 0.85 * axis.y); }
  if (axis.x > 0.0) { colour = mix(colour, axisY, axis.x); alpha = max(alpha, 0.85 * axis.x); }
  alpha *= fade;
  // Lines lie upon the shadow: both as one layer over what is behind.
  float dark = shade * (1.0 - shadowAt(vec3(place, level))) * (1.0 - alpha);
  gl_FragColor = vec4(colour * alpha / max(alpha + dark, 0.001), alpha + dark);
}`

export class Floor {
  readonly #mesh: Mesh<PlaneGeometry, ShaderMaterial>
  readonly #centre = new Vector2()

  constructor(
    private readonly parent: Object3D,
    rig: LightRig,
  ) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      defines: { ...rig.defines },
      uniforms: {
        ...rig.uniforms,
        shade: { value: 0 },
        grid: { value: new Color() },
        axisX: { value: new Color(AXIS_COLOURS[0]).convertLinearToSRGB() },
        axisY: { value: new Color(AXIS_COLOURS[1]).convertLinearToSRGB() },
        centre: { value: this.#centre },
        reach: { value: 3 },
      },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    })
    this.#mesh = new Mesh(new PlaneGeometry(2, 2), material)
    this.#mesh.renderOrder = -2
    this.#mesh.frustumCulled = false
    parent.add(this.#mesh)
  }

  /** Height in W [m]. */
  get height(): number {
    return this.#mesh.matrixWorld.elements[14] ?? 0
  }

  set palette(palette: Palette) {
    this.#uniform('grid', palette.grid.clone().convertLinearToSRGB())
    this.#uniform('shade', palette.shade)
  }

  /** Lie below everything that stands still, at z = 0 where that is low enough. */
  put(standing: Box3, all: Box3): void {
    const height = standing.isEmpty() ? 0 : Math.min(0, standing.min.z)
    const reach = all.isEmpty()
      ? 3
      : Math.max(3, 1.6 * Math.hypot(all.max.x - all.min.x, all.max.y - all.min.y))
    if (!all.isEmpty()) this.#centre.set((all.min.x + all.max.x) / 2, (all.min.y + all.max.y) / 2)
    this.#uniform('reach', reach)
    this.#mesh.matrixWorld.makeScale(reach, reach, 1).setPosition(this.#centre.x, this.#centre.y, height)
  }

  dispose(): void {
    this.parent.remove(this.#mesh)
    this.#mesh.geometry.dispose()
    this.#mesh.material.dispose()
  }

  #uniform(name: string, value: unknown): void {
    const uniform = this.#mesh.material.uniforms[name]
    if (uniform) uniform.value = value
  }
}
