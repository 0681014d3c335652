/** A material after Gouraud: light is reckoned at the corners and runs evenly across each triangle. */
import { ShaderMaterial } from 'three'
import type { LightRig } from './light_rig'

const VERTEX = /* glsl */ `
uniform vec3 direction;
uniform float ambient;
uniform float key;
varying vec3 light;
void main() {
  #include <begin_vertex>
  #include <project_vertex>
  #ifdef USE_INSTANCING
    mat4 place = modelMatrix * instanceMatrix;
  #else
    mat4 place = modelMatrix;
  #endif
  vec4 world = place * vec4(position, 1.0);
  vec3 n = normalize(mat3(place) * normal);
  float sky = 0.5 + 0.5 * n.z;
  vec3 toEye = isOrthographic
    ? vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2])
    : normalize(cameraPosition - world.xyz);
  float shine = key * 0.12 * pow(max(dot(n, normalize(direction + toEye)), 0.0), 24.0);
  light = color * (ambient * mix(vec3(0.22), vec3(0.45), sky) + key * 0.53 * max(dot(n, direction), 0.0)
    + key * 0.14 * max(dot(n, toEye), 0.0)) + shine;
}`

const FRAGMENT = /* glsl */ `
uniform float opacity;
varying vec3 light;
void main() {
  gl_FragColor = vec4(light, opacity);
  #include <colorspace_fragment>
}`

export function gouraudMaterial(rig: LightRig, opacity: number): ShaderMaterial {
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    vertexColors: true,
    uniforms: {
      direction: { value: rig.direction },
      ambient: rig.strength.ambient,
      key: rig.strength.key,
      opacity: { value: opacity },
    },
  })
  material.opacity = opacity
  return material
}
