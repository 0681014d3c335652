/** How a path of the tool is drawn: what is just past bright, older parts dim, what comes fainter still. */
import { type Color, ShaderMaterial, Vector2 } from 'three'

/** So old a part is still fully bright, and so old it has faded [s]. */
const FRESH = 2
const FADED = 5

/** Where parts fade away altogether: the share of that time in which they are fully bright. */
const BRIGHT = 0.35

/** Opacity of old parts of a short path, and the length up to which a path is short [s]. */
const OLD = 0.5
const SHORT = 15

const VERTEX = /* glsl */ `
attribute float time;
uniform float until;
varying float age;
void main() {
  age = until - time;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`

const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform float strength;
uniform float old;
uniform vec2 ages;
varying float age;
void main() {
  float fresh = 1.0 - smoothstep(ages.x, ages.y, age);
  gl_FragColor = vec4(colour, strength * mix(old, 1.0, fresh));
  #include <colorspace_fragment>
}`

/** Opacity of old parts of a path of this length [s]: many cycles over each other must not hide the work. */
export function oldOpacity(length: number): number {
  return OLD * Math.sqrt(SHORT / Math.max(length, SHORT))
}

export class TrailMaterial extends ShaderMaterial {
  constructor(strength: number) {
    super({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        colour: { value: null },
        strength: { value: strength },
        old: { value: OLD },
        ages: { value: new Vector2(FRESH, FADED) },
        until: { value: 0 },
      },
      transparent: true,
      depthWrite: false,
    })
  }

  set colour(colour: Color) {
    this.#set('colour', colour)
  }

  /** The time up to which the path is bright [s]. */
  set until(time: number) {
    this.#set('until', Math.min(time, Number.MAX_SAFE_INTEGER))
  }

  /** Older parts stay, with this opacity. */
  fadeOut(opacity: number): void {
    this.#set('old', opacity)
    this.#set('ages', new Vector2(FRESH, FADED))
  }

  /** Older parts are gone after a time [s]. */
  fadeAway(after: number): void {
    this.#set('old', 0)
    this.#set('ages', new Vector2(BRIGHT * after, after))
  }

  #set(name: string, value: unknown): void {
    const uniform = this.uniforms[name]
    if (uniform) uniform.value = value
  }
}
