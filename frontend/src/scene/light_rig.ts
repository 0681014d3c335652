/** The lights: sky and ground, a key light fixed in W, and a weak lamp that goes with the camera. */
import { type Camera, DirectionalLight, HemisphereLight, type Object3D, Vector3 } from 'three'
import type { Lights } from './settings'

export const DAYLIGHT: Lights = { ambient: 1, key: 1, azimuth: -0.75, elevation: 0.95 }

// Together they leave a white top just short of full brightness, so that it keeps its form.
const SKY = 1.45
const KEY = 1.75
const LAMP = 0.5

export class LightRig {
  readonly #sky = new HemisphereLight('#f4f8ff', '#8d8f98', SKY)
  readonly #key = new DirectionalLight('#fffaf2', KEY)
  readonly #lamp = new DirectionalLight('#ffffff', LAMP)
  #lights = DAYLIGHT
  /** Direction to the key light in W; shared with the vertex-lit material. */
  readonly direction = new Vector3()
  /** Strength of ambient and key light; shared with the vertex-lit material. */
  readonly strength = { ambient: { value: 1 }, key: { value: 1 } }

  constructor(scene: Object3D) {
    scene.add(this.#sky, this.#key, this.#lamp)
    this.#sky.matrixWorld.setPosition(0, 0, 1)
    this.lights = DAYLIGHT
  }

  get lights(): Lights {
    return this.#lights
  }

  set lights(lights: Lights) {
    this.#lights = lights
    const across = Math.cos(lights.elevation)
    this.direction.set(
      across * Math.cos(lights.azimuth),
      across * Math.sin(lights.azimuth),
      Math.sin(lights.elevation),
    )
    this.#sky.intensity = SKY * lights.ambient
    this.#key.intensity = KEY * lights.key
    this.#lamp.intensity = LAMP * lights.key
    this.#key.matrixWorld.setPosition(this.direction)
    this.strength.ambient.value = lights.ambient
    this.strength.key.value = lights.key
  }

  /** Before a viewport is drawn: the lamp goes where its camera is. */
  follow(camera: Camera): void {
    const e = camera.matrixWorld.elements
    this.#lamp.matrixWorld.setPosition(e[8] ?? 0, e[9] ?? 0, e[10] ?? 1)
  }
}
