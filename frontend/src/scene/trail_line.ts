/** A path of the tool: bright up to a time and fading before it, faint after it, or a window of it. Grows in place. */
import { BufferAttribute, BufferGeometry, type Color, Line, LineBasicMaterial, type Object3D } from 'three'
import type { PathWindow, Trail } from './settings'
import { essentialPoints } from './thin_path'
import { oldOpacity, TrailMaterial } from './trail_material'

const ROOM = 1024

/** [s] */
const FADING_STEP = 0.1

/** Opacity of what comes: as share of that of old parts, and of the next move where no more is drawn. */
const COMING = 0.6
const NEXT = 0.6

const WHOLE: PathWindow = {
  from: Number.NEGATIVE_INFINITY,
  until: Number.POSITIVE_INFINITY,
  to: Number.POSITIVE_INFINITY,
}

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
  #window: PathWindow = WHOLE
  /** [s] */
  #length = 0
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
    this.#length = length
    this.#fade()
    this.#split()
  }

  /** Set how much of the path is drawn; whether the picture is different then. */
  setWindow(window: PathWindow): boolean {
    const before = this.#window
    if (window.until === before.until && window.from === before.from && window.to === before.to) return false
    this.#window = window
    this.#past.until = window.until
    const isOther = Number.isFinite(window.from) !== Number.isFinite(before.from)
    if (isOther) this.#fade()
    // Where the tool stands still only the fading goes on: now and then is enough for that.
    const fading = this.#lines[0].visible && Math.abs(window.until - this.#drawn) > FADING_STEP
    if (!this.#split() && !fading && !isOther) return false
    this.#drawn = window.until
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

  /** Many cycles over each other are drawn faint; a window of one needs not be. */
  #fade(): void {
    const { from, until } = this.#window
    const isWhole = !Number.isFinite(from)
    if (isWhole) this.#past.fadeOut(oldOpacity(this.#length))
    else this.#past.fadeAway(until - from)
    this.#future.opacity = (isWhole ? COMING * oldOpacity(this.#length) : NEXT) * this.#strength
  }

  /** Whether another stretch is drawn than before, or the bright part ends elsewhere. */
  #split(): boolean {
    const [past, future] = this.#lines
    const count = this.#times.length
    const { from: first, until, to } = this.#window
    const passed = countUntil(this.#times, until)
    const start = Math.max(0, Math.min(countUntil(this.#times, first), passed) - 1)
    // The first point after the end belongs to it: the stretch up to there began before.
    const end = Math.min(count, countUntil(this.#times, to) + (to > until ? 1 : 0))
    const from = Math.max(0, passed - 1)
    const corner = this.#positions.array.subarray(3 * from, 3 * from + 3)
    const place = passed > 0 ? placeAt(this.#trail, until) : corner
    const head = this.#head.array
    const before = [past, future].flatMap(({ geometry: { drawRange } }) => [drawRange.start, drawRange.count])
    past.geometry.setDrawRange(start, passed - start)
    future.geometry.setDrawRange(from, Math.max(0, end - from))
    const after = [past, future].flatMap(({ geometry: { drawRange } }) => [drawRange.start, drawRange.count])
    const isMoved = head[3] !== place[0] || head[4] !== place[1] || head[5] !== place[2]
    const changed = isMoved || after.some((one, k) => one !== before[k])
    head.set(corner)
    head.set(place, 3)
    this.#head.needsUpdate = true
    this.#headTimes.array.set([this.#times[from] ?? 0, Math.min(until, this.#times[count - 1] ?? 0)])
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
