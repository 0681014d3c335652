/** A translucent surface with slanting stripes: it stands for something that could not be drawn. */
import { type Color, ShaderMaterial } from 'three'

const VERTEX = /* glsl */ `
void main() {
  #ifdef USE_INSTANCING
    mat4 place = modelMatrix * instanceMatrix;
  #else
    mat4 place = modelMatrix;
  #endif
  gl_Position = projectionMatrix * viewMatrix * place * vec4(position, 1.0);
}`

const FRAGMENT = /* glsl */ `
uniform vec3 colour;
void main() {
  float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 9.0));
  gl_FragColor = vec4(colour, mix(0.12, 0.6, stripe));
  #include <colorspace_fragment>
}`

export function hatchMaterial(colour: Color): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { colour: { value: colour } },
    transparent: true,
    depthWrite: false,
  })
}
