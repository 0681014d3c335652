/** A path of the tool: bright up to a time, faint after it. Grows without being made anew. */
import { BufferAttribute, BufferGeometry, type Color, Line, LineBasicMaterial, type Object3D } from 'three'
import type { Trail } from './settings'

const ROOM = 1024

export class TrailLine {
  readonly #past: LineBasicMaterial
  readonly #future: LineBasicMaterial
  readonly #lines: readonly [Line, Line]
  #times: Float64Array = new Float64Array(0)
  #until = Number.POSITIVE_INFINITY

  constructor(parent: Object3D, strength: number) {
    this.#past = new LineBasicMaterial({ transparent: true, opacity: strength, depthWrite: false })
    this.#future = new LineBasicMaterial({ transparent: true, opacity: 0.28 * strength, depthWrite: false })
    this.#lines = [new Line(new BufferGeometry(), this.#past), new Line(new BufferGeometry(), this.#future)]
    for (const line of this.#lines) {
      line.frustumCulled = false
      line.visible = false
      line.renderOrder = 3
      parent.add(line)
    }
    this.#reserve(ROOM)
  }

  set colour(colour: Color) {
    this.#past.color = colour
    this.#future.color = colour
  }

  set(trail: Trail | null): void {
    const count = trail ? Math.min(trail.times.length, Math.floor(trail.points.length / 3)) : 0
    this.#times = trail ? trail.times.subarray(0, count) : new Float64Array(0)
    for (const line of this.#lines) line.visible = count > 1
    if (!trail) return
    if (3 * count > this.#positions.array.length) this.#reserve(2 * count)
    const positions = this.#positions
    positions.array.set(trail.points.subarray(0, 3 * count))
    bridgeGaps(positions.array, 3 * count)
    positions.needsUpdate = true
    this.#split()
  }

  /** Set the time [s] up to which the path is bright; whether the picture is different then. */
  setUntil(time: number): boolean {
    this.#until = time
    return this.#split()
  }

  dispose(): void {
    for (const { geometry } of this.#lines) geometry.dispose()
    this.#past.dispose()
    this.#future.dispose()
  }

  get #positions(): BufferAttribute {
    return this.#lines[0].geometry.getAttribute('position') as BufferAttribute
  }

  #reserve(points: number): void {
    const positions = new BufferAttribute(new Float32Array(3 * points), 3)
    for (const { geometry } of this.#lines) {
      geometry.dispose()
      geometry.setAttribute('position', positions)
    }
  }

  #split(): boolean {
    const count = this.#times.length
    const passed = countUntil(this.#times, this.#until)
    const before = this.#lines[0].geometry.drawRange.count
    this.#lines[0].geometry.setDrawRange(0, passed)
    const from = Math.max(0, passed - 1)
    this.#lines[1].geometry.setDrawRange(from, count - from)
    return passed !== before
  }
}

/** How many of the ascending times are not after `time`. */
export function countUntil(times: Float64Array, time: number): number {
  let [low, high] = [0, times.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if ((times[middle] ?? 0) <= time) low = middle + 1
    else high = middle
  }
  return low
}

/** Where there is no position the line stays at the last one; before the first, at that. */
export function bridgeGaps(points: { [index: number]: number }, length: number): void {
  let first = 0
  while (first < length && Number.isNaN(points[first])) first += 1
  const start = first - (first % 3)
  for (let k = 0; k < length; k++) {
    if (!Number.isNaN(points[k])) continue
    points[k] = (k < 3 ? points[start + (k % 3)] : points[k - 3]) ?? 0
    if (Number.isNaN(points[k])) points[k] = 0
  }
}
