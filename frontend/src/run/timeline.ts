/**
 * The timeline of a run: play, pause, step, scrub, zoom, repeat, speed, and lanes for tasks, steps, findings, signals.
 * Moves the cursor and nothing else; whoever owns the clock calls `cursor.advance`.
 */
import { SPEEDS } from './cursor'
import { LANE_HEIGHT, SCALE_HEIGHT } from './lane_paint'
import { type Lane, shownLanes } from './lanes'
import { Track } from './track'
import type { WheelZoom } from './track_gestures'
import type { Transport } from './transport'
import { words } from './words'
import './timeline.css'

/** Called tasks stand so far to the right of their callers [px]. */
const INDENT = 8

export class Timeline {
  readonly #transport: Transport
  readonly #element = document.createElement('div')
  readonly #names = document.createElement('div')
  readonly #track: Track
  readonly #play: HTMLButtonElement
  readonly #loop: HTMLButtonElement
  readonly #whole: HTMLButtonElement
  readonly #more: HTMLButtonElement
  readonly #speed = document.createElement('select')
  readonly #reading = document.createElement('span')
  readonly #findingButtons: readonly HTMLButtonElement[]
  readonly #stop: readonly (() => void)[]
  #wanted: 'few' | 'all' = 'few'
  #lanes: readonly Lane[] = []

  constructor(host: HTMLElement, transport: Transport, wheel: WheelZoom) {
    const { cursor } = transport
    this.#transport = transport
    this.#track = new Track(cursor, wheel, () => {
      this.#whole.disabled = !this.#track.zoomed
    })
    this.#play = button('▶', words.play, () => transport.toggle())
    this.#loop = button('⟳', words.loop, () => transport.repeat(), words.loopHint)
    this.#whole = button('↔', words.whole, () => this.fit(), words.wholeHint)
    this.#whole.disabled = true
    this.#more = button('▾', words.more, () => this.#toggleLanes())
    this.#findingButtons = [
      button('⚠◂', words.previousFinding, () => transport.previousFinding()),
      button('▸⚠', words.nextFinding, () => transport.nextFinding()),
    ]
    this.#speed.setAttribute('aria-label', words.speed)
    this.#speed.title = words.speed
    for (const speed of SPEEDS) this.#speed.add(new Option(words.speedOf(speed), String(speed)))
    this.#speed.addEventListener('change', () => cursor.setSpeed(Number(this.#speed.value)))
    this.#reading.className = 'timeline-reading'
    this.#names.className = 'timeline-names'
    this.#element.className = 'timeline'
    this.#element.setAttribute('role', 'group')
    this.#element.setAttribute('aria-label', words.timeline)
    this.#element.append(
      row(
        'timeline-buttons',
        button('◂|', words.previousStep, () => transport.previousStep()),
        this.#play,
        button('|▸', words.nextStep, () => transport.nextStep()),
        this.#speed,
        this.#reading,
        ...this.#findingButtons,
        this.#loop,
        button('−', words.zoomOut, () => this.zoom('out'), words.zoomOutHint),
        button('+', words.zoomIn, () => this.zoom('in'), words.zoomInHint),
        this.#whole,
        this.#more,
      ),
      row('timeline-lanes', this.#names, this.#track.element),
    )
    this.#track.element.addEventListener('keydown', event => {
      if (this.#zoomKey(event) || transport.key(event)) event.preventDefault()
    })
    host.append(this.#element)
    this.#stop = [cursor.onTime(() => this.#follow()), cursor.onChange(() => this.#changed())]
    this.#changed()
  }

  /** Show the marks of the run that the transport has now. */
  show(): void {
    this.#changed()
  }

  /** Show less of the time around the cursor, or more. */
  zoom(direction: 'in' | 'out'): void {
    this.#track.zoomBy(direction)
  }

  /** Show the whole run. */
  fit(): void {
    this.#track.fit()
  }

  destroy(): void {
    for (const stop of this.#stop) stop()
    this.#track.destroy()
    this.#element.remove()
  }

  #zoomKey(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false
    const direction = event.key === '+' || event.key === '=' ? 'in' : event.key === '-' ? 'out' : null
    if (direction) this.zoom(direction)
    return direction !== null
  }

  #toggleLanes(): void {
    this.#wanted = this.#wanted === 'few' ? 'all' : 'few'
    this.#changed()
  }

  #follow(): void {
    const { time, end } = this.#transport.cursor
    this.#reading.textContent = words.reading(time, end)
    this.#track.follow()
  }

  #changed(): void {
    const { playing, marks, lanes } = this.#transport
    const { loop, speed } = this.#transport.cursor
    name(this.#play, playing ? '❚❚' : '▶', playing ? words.pause : words.play)
    for (const one of this.#findingButtons) one.disabled = marks.findings.length === 0
    this.#loop.setAttribute('aria-pressed', String(loop !== null))
    this.#speed.value = String(speed)
    const all = this.#wanted === 'all'
    this.#more.hidden = shownLanes(lanes, 'all').length === shownLanes(lanes, 'few').length
    this.#more.setAttribute('aria-expanded', String(all))
    name(this.#more, all ? '▴' : '▾', all ? words.fewer : words.more)
    this.#showLanes(lanes)
    this.#track.show(marks, this.#lanes)
    this.#track.relate()
    this.#follow()
  }

  #showLanes(all: readonly Lane[]): void {
    const lanes = shownLanes(all, this.#wanted)
    if (lanes.length === this.#lanes.length && lanes.every((one, at) => one === this.#lanes[at])) return
    this.#lanes = lanes
    this.#names.style.paddingTop = `${SCALE_HEIGHT}px`
    this.#names.replaceChildren(
      ...lanes.map(lane => {
        const label = document.createElement('span')
        label.textContent = lane.name
        label.title = lane.name
        label.style.paddingLeft = `${INDENT * lane.depth}px`
        label.style.height = `${LANE_HEIGHT[lane.kind]}px`
        return label
      }),
    )
  }
}

function row(className: string, ...children: readonly HTMLElement[]): HTMLElement {
  const element = document.createElement('div')
  element.className = className
  element.append(...children)
  return element
}

function name(element: HTMLButtonElement, sign: string, spoken: string): void {
  element.textContent = sign
  element.setAttribute('aria-label', spoken)
  element.title = spoken
}

function button(sign: string, spoken: string, act: () => void, hint = spoken): HTMLButtonElement {
  const element = document.createElement('button')
  element.type = 'button'
  name(element, sign, spoken)
  element.title = hint
  element.addEventListener('click', act)
  return element
}
