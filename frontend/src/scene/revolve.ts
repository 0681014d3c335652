/** Bodies of revolution about z: cylinders, cones, spheres and free profiles. */
import { chords, emptySolid, SMOOTH_ANGLE, type Solid } from './solid'

type Profile = readonly (readonly [number, number])[]

/** Lines along the surface that a wire drawing shows. */
const MERIDIANS = 8

interface Band {
  readonly from: readonly [number, number]
  readonly to: readonly [number, number]
  /** Outward normal in the half plane r, z. */
  readonly normal: readonly [number, number]
}

/** Turn (r, z) points, from the lower to the upper end, about z. Ends off the axis stay open. */
export function revolve(profile: Profile): Solid {
  const ordered = signedVolume(profile) < 0 ? [...profile].reverse() : profile
  const bands = bandsOf(ordered)
  const first = ordered[0] ?? [0, 0]
  const last = ordered.at(-1) ?? [0, 0]
  const ring = Math.hypot(first[0] - last[0], first[1] - last[1]) < 1e-9
  const solid = emptySolid(!ring && (first[0] > 1e-9 || last[0] > 1e-9))
  const widest = Math.max(...ordered.map(([r]) => r), 0)
  const sides = chords(widest)
  bands.forEach((band, k) => {
    const before = bands[k - 1] ?? (ring ? bands.at(-1) : undefined)
    const after = bands[k + 1] ?? (ring ? bands[0] : undefined)
    const low = smooth(before, band) ? mean(before, band) : band.normal
    const high = smooth(after, band) ? mean(after, band) : band.normal
    addBand(solid, band, low, high, sides)
    if (!smooth(before, band)) addCircle(solid.creases, band.from, sides)
    if (!after) addCircle(solid.creases, band.to, sides)
    addMeridians(solid.contours, band)
  })
  return solid
}

export function cylinder(radius: number, top: number, length: number): Solid {
  const [low, high] = [-length / 2, length / 2]
  return revolve([
    [0, low],
    [radius, low],
    [top, high],
    [0, high],
  ])
}

export function sphere(radius: number): Solid {
  const steps = chords(radius) / 2
  const profile = Array.from({ length: steps + 1 }, (_, k) => {
    const angle = -Math.PI / 2 + (Math.PI * k) / steps
    const r = k === 0 || k === steps ? 0 : radius * Math.cos(angle)
    return [r, radius * Math.sin(angle)] as const
  })
  const solid = revolve(profile)
  addCircle(solid.contours, [radius, 0], chords(radius))
  return solid
}

/** Enclosed volume over π of the surface of revolution (Pappus), its sign telling the sense of the profile. */
function signedVolume(profile: Profile): number {
  let sum = 0
  for (let k = 1; k < profile.length; k++) {
    const [r0, z0] = profile[k - 1] ?? [0, 0]
    const [r1, z1] = profile[k] ?? [0, 0]
    sum += ((z1 - z0) * (r0 * r0 + r0 * r1 + r1 * r1)) / 3
  }
  return sum
}

function bandsOf(profile: Profile): Band[] {
  const bands: Band[] = []
  for (let k = 1; k < profile.length; k++) {
    const from = profile[k - 1] ?? [0, 0]
    const to = profile[k] ?? [0, 0]
    const [dr, dz] = [to[0] - from[0], to[1] - from[1]]
    const length = Math.hypot(dr, dz)
    if (length > 1e-12 && (from[0] > 0 || to[0] > 0)) {
      bands.push({ from, to, normal: [dz / length, -dr / length] })
    }
  }
  return bands
}

function smooth(a: Band | undefined, b: Band): a is Band {
  return a !== undefined && a.normal[0] * b.normal[0] + a.normal[1] * b.normal[1] > Math.cos(SMOOTH_ANGLE)
}

function mean(a: Band, b: Band): readonly [number, number] {
  const [r, z] = [a.normal[0] + b.normal[0], a.normal[1] + b.normal[1]]
  const length = Math.hypot(r, z)
  return [r / length, z / length]
}

function addBand(
  solid: Solid,
  band: Band,
  low: readonly [number, number],
  high: readonly [number, number],
  sides: number,
): void {
  const start = solid.positions.length / 3
  for (let k = 0; k <= sides; k++) {
    const angle = (2 * Math.PI * (k % sides)) / sides
    const [c, s] = [Math.cos(angle), Math.sin(angle)]
    solid.positions.push(band.from[0] * c, band.from[0] * s, band.from[1])
    solid.positions.push(band.to[0] * c, band.to[0] * s, band.to[1])
    solid.normals.push(low[0] * c, low[0] * s, low[1], high[0] * c, high[0] * s, high[1])
    if (k === sides) break
    const i = start + 2 * k
    if (band.from[0] > 0) solid.indices.push(i, i + 2, i + 1)
    if (band.to[0] > 0) solid.indices.push(i + 1, i + 2, i + 3)
  }
}

function addCircle(lines: number[], [r, z]: readonly [number, number], sides: number): void {
  if (r < 1e-9) return
  for (let k = 0; k < sides; k++) {
    const [a, b] = [(2 * Math.PI * k) / sides, (2 * Math.PI * (k + 1)) / sides]
    lines.push(r * Math.cos(a), r * Math.sin(a), z, r * Math.cos(b), r * Math.sin(b), z)
  }
}

function addMeridians(lines: number[], { from, to }: Band): void {
  if (Math.abs(to[1] - from[1]) < 1e-9) return
  for (let k = 0; k < MERIDIANS; k++) {
    const [c, s] = [Math.cos((2 * Math.PI * k) / MERIDIANS), Math.sin((2 * Math.PI * k) / MERIDIANS)]
    lines.push(from[0] * c, from[0] * s, from[1], to[0] * c, to[0] * s, to[1])
  }
}
