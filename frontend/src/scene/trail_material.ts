/** How a path of the tool is drawn: what is just past bright, older parts dim, what comes fainter still. */
import { type Color, ShaderMaterial } from 'three'

/** So long a part stays fully bright, and so long it then takes to fade [s]. */
const FRESH = 2
const FADING = 3

/** Opacity of old parts of a short path, and the length up to which a path is short [s]. */
const OLD = 0.5
const SHORT = 15

/** Opacity of what comes, as share of that of old parts. */
const COMING = 0.6

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
varying float age;
void main() {
  float fresh = 1.0 - smoothstep(${FRESH.toFixed(1)}, ${(FRESH + FADING).toFixed(1)}, age);
  gl_FragColor = vec4(colour, strength * mix(old, 1.0, fresh));
  #include <colorspace_fragment>
}`

/** Opacity of old parts of a path of this length [s]: many cycles over each other must not hide the work. */
export function oldOpacity(length: number): number {
  return OLD * Math.sqrt(SHORT / Math.max(length, SHORT))
}

export function comingOpacity(length: number): number {
  return COMING * oldOpacity(length)
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

  /** The length of the path [s]. */
  set length(length: number) {
    this.#set('old', oldOpacity(length))
  }

  #set(name: string, value: unknown): void {
    const uniform = this.uniforms[name]
    if (uniform) uniform.value = value
  }
}
