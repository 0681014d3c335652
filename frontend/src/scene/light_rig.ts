/** The lights: sky and ground, a key light fixed in W that throws shadows, and a weak lamp at the eye. */
import { Matrix4, type Texture, Vector3 } from 'three'
import { DAYLIGHT, type Lights } from './settings'
import { tier } from './tier'

export class LightRig {
  #lights = DAYLIGHT
  /** Direction to the key light in W. */
  readonly direction = new Vector3()
  /** What every lit material shares. */
  readonly uniforms = {
    direction: { value: this.direction },
    ambient: { value: 1 },
    key: { value: 1 },
    shadowMap: { value: null as Texture | null },
    shadowMatrix: { value: new Matrix4() },
    /** Edge of one sample of the shadow map, as share of the map; 0 while there are no shadows. */
    shadowStep: { value: 0 },
  }
  /** Where the processor draws, edges of shadows are looked up once instead of four times. */
  readonly defines: Readonly<Record<string, string>> = tier() === 'soft' ? {} : { SOFT_EDGES: '' }

  constructor() {
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
    this.uniforms.ambient.value = lights.ambient
    this.uniforms.key.value = lights.key
  }
}
