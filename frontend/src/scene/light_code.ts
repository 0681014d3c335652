/** Light and shadow as shaders reckon them: one set of words for surfaces, however they are shaded, and the floor. */

/**
 * `shadowAt(place)`: share of the key light that reaches a place of W, 0 … 1. Where there is no map all is lit.
 * The map keeps depths; comparing and mixing of its four nearest samples is the texture unit's work.
 */
export const SHADOW = /* glsl */ `
uniform highp sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;
uniform float shadowStep;
float shadowAt(vec3 place) {
  if (shadowStep <= 0.0) return 1.0;
  vec3 p = (shadowMatrix * vec4(place, 1.0)).xyz;
  if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
#ifdef SOFT_EDGES
  vec2 s = vec2(shadowStep, -shadowStep);
  return 0.25 * (texture(shadowMap, vec3(p.xy + s.xx, p.z)) + texture(shadowMap, vec3(p.xy + s.xy, p.z))
    + texture(shadowMap, vec3(p.xy + s.yx, p.z)) + texture(shadowMap, vec3(p.xy + s.yy, p.z)));
#else
  return texture(shadowMap, p);
#endif
}`

/**
 * `lightOn(…)`: what a surface throws to the eye, apart for `still`, the light that comes from all round and from the
 * eye, and `sun`, the key light, which a shadow takes away. Diffuse after Lambert; highlights after Blinn and Phong,
 * normalised; mirrored is a room of light grey with a bright band above, stronger at grazing angles after Schlick.
 */
export const LIGHT = /* glsl */ `
uniform vec3 direction;
uniform float ambient;
uniform float key;
vec3 room(vec3 r, float gloss) {
  float soft = 0.5 * (1.0 - gloss);
  float wall = smoothstep(-0.15 - soft, 0.15 + soft, r.z);
  float band = smoothstep(0.1 - soft, 0.5, r.z) * (1.0 - smoothstep(0.72, 0.95 + soft, r.z));
  return vec3(mix(0.10, 0.36, wall) + 1.1 * band * (0.72 + 0.28 * r.x));
}
void lightOn(vec3 colour, vec3 n, vec3 v, float gloss, float metal, out vec3 still, out vec3 sun) {
  float facing = max(dot(n, v), 0.0);
  float lit = max(dot(n, direction), 0.0);
  vec3 body = colour * (1.0 - 0.8 * metal);
  still = body * (ambient * mix(vec3(0.20, 0.20, 0.22), vec3(0.45, 0.46, 0.48), 0.5 + 0.5 * n.z)
    + key * 0.13 * facing);
  sun = body * (key * 0.55 * lit);
  if (gloss <= 0.0) return;
  vec3 mirror = mix(vec3(0.04), colour, metal);
  mirror += (1.0 - mirror) * gloss * pow(1.0 - facing, 5.0);
  still += ambient * mirror * room(reflect(-v, n), gloss);
  float sharp = exp2(2.0 + 7.0 * gloss);
  float shine = pow(max(dot(n, normalize(direction + v)), 0.0), sharp) * (sharp + 8.0) * 0.04;
  // The key light falls upon a surface with pi times what it is seen with after Lambert.
  sun += mix(vec3(0.04), colour, metal) * (key * 1.7 * lit * shine);
}`

/** Towards the eye from a place of W. */
export const TO_EYE = /* glsl */ `
vec3 eyeAxis() { return vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]); }
vec3 toEye(vec3 place) { return isOrthographic ? eyeAxis() : normalize(cameraPosition - place); }`
