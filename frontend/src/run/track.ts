/** The picture of the timeline: scale, lanes, playhead and scrubbing; a slider for assistive technology. */
import { onScheme } from '../style/scheme'
import type { Cursor } from './cursor'
import { LANE_HEIGHT, paintLane, paintScale, SCALE_HEIGHT } from './lane_paint'
import { barAt, type Lane } from './lanes'
import { type Marks, NO_MARKS, nearest, stepAt } from './marks'
import { TimeWindow } from './time_window'
import { trackGestures, type WheelZoom } from './track_gestures'
import { words } from './words'

/** How near a click must be to a finding to land on it exactly [px]. */
const SNAP = 5
/** A live run grows always: it is drawn again when its end has moved so far [px]. */
const GROWTH = 2
/** Zoom of a key or button. */
const STEP = 1.6

export class Track {
  readonly element = document.createElement('div')
  readonly #canvas = document.createElement('canvas')
  readonly #head = document.createElement('div')
  readonly #range = document.createElement('div')
  readonly #tip = document.createElement('div')
  readonly #cursor: Cursor
  readonly #window = new TimeWindow()
  readonly #changed: () => void
  readonly #stops: readonly (() => void)[]
  #marks: Marks = NO_MARKS
  #lanes: readonly Lane[] = []
  /** Length of the run that was drawn last. */
  #drawnEnd = Number.NaN
  #width = 0
  #playAfter = false

  /** `changed` hears of another stretch of time in sight. */
  constructor(cursor: Cursor, wheel: WheelZoom, changed: () => void) {
    this.#cursor = cursor
    this.#changed = changed
    this.element.className = 'timeline-track'
    this.element.tabIndex = 0
    this.element.setAttribute('role', 'slider')
    this.element.setAttribute('aria-label', words.time)
    this.element.setAttribute('aria-valuemin', '0')
    this.#range.className = 'timeline-range'
    this.#head.className = 'timeline-head'
    this.#tip.className = 'timeline-tip'
    this.#tip.hidden = true
    const clip = document.createElement('div')
    clip.className = 'timeline-clip'
    clip.append(this.#canvas, this.#range, this.#head)
    this.element.append(clip, this.#tip)
    const sizes = new ResizeObserver(() => this.#resize())
    sizes.observe(this.element)
    this.#stops = [
      trackGestures(this.element, wheel, {
        grasp: x => this.#grasp(x),
        drag: x => this.#drag(x),
        drop: () => this.#drop(),
        select: (from, to) => this.#select(from, to),
        hover: (x, y) => this.#tell(x, y),
        leave: () => {
          this.#tip.hidden = true
        },
        zoom: (factor, x) => this.#zoom(factor, this.#window.time(x, this.#width)),
        pan: pixels => this.#pan(pixels),
      }),
      onScheme(() => this.#draw()),
      () => sizes.disconnect(),
    ]
  }

  get zoomed(): boolean {
    return this.#window.zoomed
  }

  show(marks: Marks, lanes: readonly Lane[]): void {
    if (marks === this.#marks && lanes === this.#lanes) return
    this.#marks = marks
    this.#lanes = lanes
    const height = lanes.reduce((sum, lane) => sum + LANE_HEIGHT[lane.kind], SCALE_HEIGHT)
    this.element.style.height = `${Math.max(height, 2 * SCALE_HEIGHT)}px`
    this.#draw()
  }

  /** Zoom in or out around the cursor, or around the middle where that is out of sight. */
  zoomBy(direction: 'in' | 'out'): void {
    const { from, to } = this.#window
    const { time } = this.#cursor
    const about = time >= from && time <= to ? time : (from + to) / 2
    this.#zoom(direction === 'in' ? STEP : 1 / STEP, about)
  }

  fit(): void {
    this.#window.fit()
    this.#redraw()
  }

  /** Follow the cursor's time; cheap enough for every frame. */
  follow(): void {
    const { time, end } = this.#cursor
    this.#window.setEnd(end) // the cursor of a shorter run has moved already
    if (this.#window.follow(time)) this.#redraw()
    const x = this.#window.x(time, this.#width)
    this.#head.style.transform = `translateX(${x}px)`
    const now = time.toFixed(1)
    if (this.element.getAttribute('aria-valuenow') === now) return
    const step = stepAt(this.#marks, time)
    const text = step ? `${words.line(step.line)} ${step.text}` : ''
    this.element.setAttribute('aria-valuenow', now)
    this.element.setAttribute('aria-valuetext', words.valueText(time, end, text))
  }

  /** Take over a new length of the run or a new loop. */
  relate(): void {
    const { end, loop } = this.#cursor
    this.#window.setEnd(end)
    this.element.setAttribute('aria-valuemax', end.toFixed(1))
    this.#frame(loop)
    const moved = Math.abs(end - this.#drawnEnd) * (this.#width / Math.max(end, 1e-9))
    if (!(moved < GROWTH)) this.#draw()
  }

  destroy(): void {
    for (const stop of this.#stops) stop()
    this.element.remove()
  }

  #frame(loop: readonly [number, number] | null): void {
    this.#range.hidden = loop === null
    if (!loop) return
    const [left, right] = loop.map(time => this.#window.x(time, this.#width)) as [number, number]
    this.#range.style.left = `${left}px`
    this.#range.style.width = `${right - left}px`
  }

  #grasp(x: number): void {
    this.#playAfter = this.#cursor.playing
    this.#cursor.pause()
    const time = this.#window.time(x, this.#width)
    this.#cursor.seek(nearest(this.#marks.findings, time, this.#reach())?.time ?? time)
  }

  #drag(x: number): void {
    this.#cursor.seek(this.#window.time(x, this.#width))
  }

  #drop(): void {
    if (this.#playAfter) this.#cursor.play()
    this.#playAfter = false
  }

  #select(from: number, to: number): void {
    const [a, b] = [this.#window.time(from, this.#width), this.#window.time(to, this.#width)]
    if (a !== b) this.#cursor.setLoop([Math.min(a, b), Math.max(a, b)])
  }

  #zoom(factor: number, about: number): void {
    this.#window.zoom(factor, about)
    this.#redraw()
  }

  #pan(pixels: number): void {
    this.#window.pan((pixels / Math.max(this.#width, 1)) * (this.#window.to - this.#window.from))
    this.#redraw()
  }

  #tell(x: number, y: number): void {
    const time = this.#window.time(x, this.#width)
    this.#tip.textContent = [`${time.toFixed(2)} s`, this.#wordsAt(time, y)].filter(Boolean).join(' · ')
    this.#tip.hidden = false
    this.#tip.classList.toggle('timeline-tip-left', x > this.#width / 2)
    this.#tip.style.transform = `translateX(${Math.min(Math.max(x, 0), this.#width)}px)`
  }

  #wordsAt(time: number, y: number): string {
    const found = nearest(this.#marks.findings, time, this.#reach())
    if (found) return found.text
    const input = nearest(this.#marks.inputs, time, this.#reach())
    if (input) return words.input(input.text)
    const lane = this.#laneAt(y)
    const bar = lane && lane.kind !== 'steps' ? barAt(lane.bars, time) : undefined
    if (lane && bar) return lane.kind === 'held' ? `${lane.name}: ${bar.text}` : bar.text
    const step = stepAt(this.#marks, time)
    return step ? `${words.line(step.line)} · ${step.text}` : ''
  }

  #laneAt(y: number): Lane | undefined {
    let bottom = SCALE_HEIGHT
    return this.#lanes.find(lane => {
      bottom += LANE_HEIGHT[lane.kind]
      return y >= bottom - LANE_HEIGHT[lane.kind] && y < bottom
    })
  }

  #reach(): number {
    return (SNAP / Math.max(this.#width, 1)) * (this.#window.to - this.#window.from)
  }

  #resize(): void {
    this.#width = this.element.clientWidth
    this.#redraw()
  }

  #redraw(): void {
    this.#draw()
    this.#frame(this.#cursor.loop)
    this.#head.style.transform = `translateX(${this.#window.x(this.#cursor.time, this.#width)}px)`
    this.#changed()
  }

  #draw(): void {
    this.#drawnEnd = this.#cursor.end
    const ratio = window.devicePixelRatio || 1
    const height = this.element.clientHeight
    this.#canvas.width = Math.round(this.#width * ratio)
    this.#canvas.height = Math.round(height * ratio)
    const context = this.#canvas.getContext('2d')
    if (!context || this.#width === 0) return
    const style = getComputedStyle(this.element)
    const colour = (name: string) => style.getPropertyValue(name).trim() || 'gray'
    context.scale(ratio, ratio)
    const canvas = { context, width: this.#width, window: this.#window, colour }
    paintScale(canvas, height)
    let top = SCALE_HEIGHT
    for (const lane of this.#lanes) {
      paintLane(canvas, lane, top)
      top += LANE_HEIGHT[lane.kind]
    }
  }
}
