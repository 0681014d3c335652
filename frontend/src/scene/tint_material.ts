/** A translucent surface in one colour, denser where it turns away from the eye: its form is seen without any light. */
import { type Color, DoubleSide, ShaderMaterial } from 'three'
import { TO_EYE } from './light_code'

const VERTEX = /* glsl */ `
varying vec3 place;
varying vec3 normalAt;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xyz;
  normalAt = mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * viewMatrix * world;
}`

const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform float strength;
varying vec3 place;
varying vec3 normalAt;
${TO_EYE}
void main() {
  float facing = abs(dot(normalize(normalAt), toEye(place)));
  gl_FragColor = vec4(colour * (0.7 + 0.3 * facing), strength * mix(1.7, 0.8, facing));
  #include <colorspace_fragment>
}`

export class TintMaterial extends ShaderMaterial {
  constructor(strength: number) {
    super({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { colour: { value: null }, strength: { value: strength } },
      transparent: true,
      side: DoubleSide,
      depthWrite: false,
    })
  }

  set colour(colour: Color) {
    if (this.uniforms.colour) this.uniforms.colour.value = colour
  }
}
