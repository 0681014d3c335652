/** A path of the tool: bright up to a time and fading before it, faint after it. Grows without being made anew. */
import { BufferAttribute, BufferGeometry, type Color, Line, LineBasicMaterial, type Object3D } from 'three'
import type { Trail } from './settings'
import { essentialPoints } from './thin_path'
import { comingOpacity, TrailMaterial } from './trail_material'

const ROOM = 1024

/** [s] */
const FADING_STEP = 0.1

const NOWHERE: Trail = { times: new Float64Array(0), points: new Float32Array(0) }

export class TrailLine {
  readonly #past: TrailMaterial
  readonly #future: LineBasicMaterial
  /** What has passed, what comes, and the last bit up to the very time. */
  readonly #lines: readonly [Line, Line, Line]
  readonly #head = new BufferAttribute(new Float32Array(6), 3)
  readonly #headTimes = new BufferAttribute(new Float32Array(2), 1)
  readonly #strength: number
  /** All points, and the times of those that are drawn. */
  #trail = NOWHERE
  #times: Float64Array = new Float64Array(0)
  #until = Number.POSITIVE_INFINITY
  /** The time of the last picture that was different. */
  #drawn = Number.NEGATIVE_INFINITY

  constructor(parent: Object3D, strength: number) {
    this.#strength = strength
    this.#past = new TrailMaterial(strength)
    this.#future = new LineBasicMaterial({ transparent: true, depthWrite: false })
    this.#lines = [
      new Line(new BufferGeometry(), this.#past),
      new Line(new BufferGeometry(), this.#future),
      new Line(
        new BufferGeometry().setAttribute('position', this.#head).setAttribute('time', this.#headTimes),
        this.#past,
      ),
    ]
    for (const line of this.#lines) {
      line.frustumCulled = false
      line.visible = false
      line.renderOrder = 3
      parent.add(line)
    }
    this.#reserve(ROOM)
  }

  set colour(colour: Color) {
    this.#past.colour = colour
    this.#future.color = colour
  }

  set(trail: Trail | null): void {
    const count = trail ? Math.min(trail.times.length, Math.floor(trail.points.length / 3)) : 0
    for (const line of this.#lines) line.visible = count > 1
    this.#trail = trail
      ? { times: trail.times.subarray(0, count), points: trail.points.slice(0, 3 * count) }
      : NOWHERE
    const { times, points } = this.#trail
    bridgeGaps(points, 3 * count)
    const kept = essentialPoints(points, count)
    this.#times = Float64Array.from(kept, index => times[index] ?? 0)
    if (3 * kept.length > this.#positions.array.length) this.#reserve(2 * kept.length)
    const [positions, stamps] = [this.#positions, this.#stamps]
    kept.forEach((index, at) => {
      positions.array.set(points.subarray(3 * index, 3 * index + 3), 3 * at)
    })
    stamps.array.set(this.#times)
    positions.needsUpdate = true
    stamps.needsUpdate = true
    const length = (times[count - 1] ?? 0) - (times[0] ?? 0)
    this.#past.length = length
    this.#future.opacity = comingOpacity(length) * this.#strength
    this.#split()
  }

  /** Set the time [s] up to which the path is bright; whether the picture is different then. */
  setUntil(time: number): boolean {
    if (time === this.#until) return false
    this.#until = time
    this.#past.until = time
    // Where the tool stands still only the fading goes on: now and then is enough for that.
    const fading = this.#lines[0].visible && Math.abs(time - this.#drawn) > FADING_STEP
    if (!this.#split() && !fading) return false
    this.#drawn = time
    return true
  }

  dispose(): void {
    for (const { geometry } of this.#lines) geometry.dispose()
    this.#past.dispose()
    this.#future.dispose()
  }

  get #positions(): BufferAttribute {
    return this.#lines[0].geometry.getAttribute('position') as BufferAttribute
  }

  /** The times of the points, as the processor of the picture takes them. */
  get #stamps(): BufferAttribute {
    return this.#lines[0].geometry.getAttribute('time') as BufferAttribute
  }

  #reserve(points: number): void {
    const positions = new BufferAttribute(new Float32Array(3 * points), 3)
    const stamps = new BufferAttribute(new Float32Array(points), 1)
    for (const { geometry } of this.#lines.slice(0, 2)) {
      geometry.dispose()
      geometry.setAttribute('position', positions)
      geometry.setAttribute('time', stamps)
    }
  }

  /** Whether the bright part ends elsewhere than before. */
  #split(): boolean {
    const [past, future] = this.#lines
    const count = this.#times.length
    const passed = countUntil(this.#times, this.#until)
    const from = Math.max(0, passed - 1)
    const corner = this.#positions.array.subarray(3 * from, 3 * from + 3)
    const end = passed > 0 ? placeAt(this.#trail, this.#until) : corner
    const head = this.#head.array
    const before = past.geometry.drawRange.count
    const changed = passed !== before || head[3] !== end[0] || head[4] !== end[1] || head[5] !== end[2]
    past.geometry.setDrawRange(0, passed)
    future.geometry.setDrawRange(from, count - from)
    head.set(corner)
    head.set(end, 3)
    this.#head.needsUpdate = true
    this.#headTimes.array.set([this.#times[from] ?? 0, Math.min(this.#until, this.#times[count - 1] ?? 0)])
    this.#headTimes.needsUpdate = true
    return changed
  }
}

/** Where the tool is at a time, clamped to the trail. */
export function placeAt({ times, points }: Trail, time: number): Float32Array {
  const after = Math.min(countUntil(times, time), times.length - 1)
  const before = Math.max(after - 1, 0)
  const [start, end] = [times[before] ?? 0, times[after] ?? 0]
  const share = end > start ? Math.min(Math.max((time - start) / (end - start), 0), 1) : 0
  const at = (axis: number) => {
    const from = points[3 * before + axis] ?? 0
    return from + share * ((points[3 * after + axis] ?? 0) - from)
  }
  return Float32Array.of(at(0), at(1), at(2))
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
