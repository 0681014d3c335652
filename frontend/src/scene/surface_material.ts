/** How surfaces are painted: one tone for each face (flat), light at corners (Gouraud), or at each pixel (smooth). */
import { ShaderMaterial } from 'three'
import { LIGHT, SHADOW, TO_EYE } from './light_code'
import type { LightRig } from './light_rig'

export type Shades = 'flat' | 'gouraud' | 'standard'

/** Places are looked up this far above the surface, along its normal, or it would shade itself [m]. */
const LIFT = '0.004'

const VERTEX = /* glsl */ `
attribute vec4 finish;
varying vec3 place;
#ifdef AT_CORNERS
  varying vec3 shown;
  ${LIGHT}
  ${TO_EYE}
#else
  varying vec3 tone;
  varying vec3 normalAt;
  varying vec2 gloss;
  varying vec4 fibre;
#endif
void main() {
  #ifdef USE_INSTANCING
    mat4 body = modelMatrix * instanceMatrix;
  #else
    mat4 body = modelMatrix;
  #endif
  vec4 world = body * vec4(position, 1.0);
  vec3 n = normalize(mat3(body) * normal);
  place = world.xyz;
  #ifdef AT_CORNERS
    vec3 still, sun;
    lightOn(color.rgb, n, toEye(place), finish.x, finish.y, still, sun);
    shown = still + sun;
  #else
    tone = color.rgb;
    normalAt = n;
    gloss = finish.xy;
    // The fibres run along the first of three: x, y or z of the body.
    float axis = finish.z * 3.0;
    fibre = vec4(axis < 1.5 ? position : axis < 2.5 ? position.yzx : position.zxy, min(axis, 1.0));
  #endif
  gl_Position = projectionMatrix * viewMatrix * world;
}`

const FRAGMENT = /* glsl */ `
uniform float opacity;
varying vec3 place;
#ifdef AT_CORNERS
  varying vec3 shown;
#else
  varying vec3 tone;
  varying vec3 normalAt;
  varying vec2 gloss;
  varying vec4 fibre;
  ${LIGHT}
  ${TO_EYE}
  ${SHADOW}
  // Fibres and rings, fading where they would be finer than pixels.
  float grain(vec3 p) {
    float turn = sin(9.0 * p.x + 5.0 * p.z) + 0.6 * sin(23.0 * p.x + 40.0 * p.y);
    float fine = 420.0 * p.y + 310.0 * p.z + 2.2 * turn;
    float coarse = 105.0 * p.y + 80.0 * p.z + 1.3 * turn;
    return 0.09 * sin(fine) * (1.0 - smoothstep(0.8, 2.6, fwidth(fine)))
      + 0.08 * sin(coarse) * (1.0 - smoothstep(0.8, 2.6, fwidth(coarse)));
  }
#endif
void main() {
  #ifndef AT_CORNERS
    vec3 still, sun;
    #ifdef BY_FACES
      vec3 n = normalize(cross(dFdx(place), dFdy(place)));
      lightOn(tone, n, eyeAxis(), 0.0, 0.0, still, sun);
      vec3 shown = still + sun;
    #else
      vec3 n = normalize(gl_FrontFacing ? normalAt : -normalAt);
      vec3 colour = tone;
      if (fibre.w > 0.5) colour *= 1.0 + grain(fibre.xyz);
      lightOn(colour, n, toEye(place), gloss.x, gloss.y, still, sun);
      vec3 shown = still + sun * shadowAt(place + ${LIFT} * n);
    #endif
  #endif
  gl_FragColor = vec4(shown, opacity);
  #include <colorspace_fragment>
}`

export function surfaceMaterial(rig: LightRig, shades: Shades, opacity: number): ShaderMaterial {
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    vertexColors: true,
    uniforms: { ...rig.uniforms, opacity: { value: opacity } },
    defines: {
      ...(shades === 'gouraud' && { AT_CORNERS: '' }),
      ...(shades === 'flat' && { BY_FACES: '' }),
      ...rig.defines,
    },
  })
  material.opacity = opacity
  return material
}
