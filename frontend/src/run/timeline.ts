/**
 * The timeline of a run: play, pause, step, scrub, repeat, speed, and marks for steps and findings.
 * Moves the cursor and nothing else; whoever owns the clock calls `cursor.advance`.
 */
import { SPEEDS } from './cursor'
import { Track } from './track'
import type { Transport } from './transport'
import { words } from './words'
import './timeline.css'

export class Timeline {
  readonly #transport: Transport
  readonly #element = document.createElement('div')
  readonly #track: Track
  readonly #play: HTMLButtonElement
  readonly #loop: HTMLButtonElement
  readonly #speed = document.createElement('select')
  readonly #reading = document.createElement('span')
  readonly #findingButtons: readonly HTMLButtonElement[]
  readonly #stop: readonly (() => void)[]

  constructor(host: HTMLElement, transport: Transport) {
    const { cursor } = transport
    this.#transport = transport
    this.#track = new Track(cursor)
    this.#play = button('▶', words.play, () => transport.toggle())
    this.#loop = button('⟳', words.loop, () => transport.repeat())
    this.#loop.title = words.loopHint
    this.#findingButtons = [
      button('⚠◂', words.previousFinding, () => transport.previousFinding()),
      button('▸⚠', words.nextFinding, () => transport.nextFinding()),
    ]
    this.#speed.setAttribute('aria-label', words.speed)
    for (const speed of SPEEDS) this.#speed.add(new Option(words.speedOf(speed), String(speed)))
    this.#speed.addEventListener('change', () => cursor.setSpeed(Number(this.#speed.value)))
    this.#reading.className = 'timeline-reading'
    this.#element.className = 'timeline'
    this.#element.setAttribute('role', 'group')
    this.#element.setAttribute('aria-label', words.timeline)
    this.#element.append(
      button('◂|', words.previousStep, () => transport.previousStep()),
      this.#play,
      button('|▸', words.nextStep, () => transport.nextStep()),
      this.#track.element,
      this.#reading,
      ...this.#findingButtons,
      this.#loop,
      this.#speed,
    )
    this.#track.element.addEventListener('keydown', event => {
      if (transport.key(event)) event.preventDefault()
    })
    host.append(this.#element)
    this.#stop = [cursor.onTime(() => this.#follow()), cursor.onChange(() => this.#changed())]
    this.#changed()
  }

  /** Show the marks of the run that the transport has now. */
  show(): void {
    this.#changed()
  }

  destroy(): void {
    for (const stop of this.#stop) stop()
    this.#track.destroy()
    this.#element.remove()
  }

  #follow(): void {
    const { time, end } = this.#transport.cursor
    this.#reading.textContent = words.reading(time, end)
    this.#track.follow()
  }

  #changed(): void {
    const { playing, loop, speed } = this.#transport.cursor
    this.#play.textContent = playing ? '❚❚' : '▶'
    this.#play.setAttribute('aria-label', playing ? words.pause : words.play)
    this.#play.title = playing ? words.pause : words.play
    for (const one of this.#findingButtons) one.disabled = this.#transport.marks.findings.length === 0
    this.#loop.setAttribute('aria-pressed', String(loop !== null))
    this.#speed.value = String(speed)
    this.#track.show(this.#transport.marks)
    this.#track.relate()
    this.#follow()
  }
}

function button(sign: string, name: string, act: () => void): HTMLButtonElement {
  const element = document.createElement('button')
  element.type = 'button'
  element.textContent = sign
  element.title = name
  element.setAttribute('aria-label', name)
  element.addEventListener('click', act)
  return element
}
