/** A path with fewer points that looks the same: straight and standing stretches need none inside. */

/** How far the thinned path may be from the whole one [m]: less than a pixel unless one looks from very near. */
export const TOLERANCE = 2e-4

/** So many points at most does one straight piece stand for; it bounds the work for each. */
const LONGEST = 32

/** Indices of the points that stay, first and last among them; three numbers for each of `count` points. */
export function essentialPoints(points: Float32Array, count: number): Uint32Array {
  const kept = new Uint32Array(count)
  if (count === 0) return kept
  let size = 1
  let from = 0
  for (let to = 2; to < count; to++) {
    if (to - from <= LONGEST && isStraight(points, from, to)) continue
    from = to - 1
    kept[size++] = from
  }
  if (count > 1) kept[size++] = count - 1
  return kept.subarray(0, size)
}

/** Whether all points between two lie on the straight piece that joins these. */
function isStraight(points: Float32Array, from: number, to: number): boolean {
  const at = (index: number) => points[index] ?? 0
  const [a, b] = [3 * from, 3 * to]
  const [x, y, z] = [at(a), at(a + 1), at(a + 2)]
  const [dx, dy, dz] = [at(b) - x, at(b + 1) - y, at(b + 2) - z]
  const length = dx * dx + dy * dy + dz * dz
  for (let k = a + 3; k < b; k += 3) {
    const [px, py, pz] = [at(k) - x, at(k + 1) - y, at(k + 2) - z]
    const along = px * dx + py * dy + pz * dz
    const share = length > 0 ? Math.min(Math.max(along / length, 0), 1) : 0
    const [ax, ay, az] = [px - share * dx, py - share * dy, pz - share * dz]
    if (ax * ax + ay * ay + az * az > TOLERANCE * TOLERANCE) return false
  }
  return true
}
