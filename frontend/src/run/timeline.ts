/**
 * The timeline of a run: play, pause, step, scrub, repeat, speed, and marks for steps and findings.
 * Moves the cursor and nothing else; whoever owns the clock calls `cursor.advance`.
 */
import { type Cursor, SPEEDS } from './cursor'
import { firstAfter, lastBefore, type Marks, marksOf } from './marks'
import type { Run } from './run'
import { Track } from './track'
import { words } from './words'
import './timeline.css'

const NONE: Marks = { steps: [], findings: [] }

export class Timeline {
  readonly #cursor: Cursor
  readonly #element = document.createElement('div')
  readonly #track: Track
  readonly #play: HTMLButtonElement
  readonly #loop: HTMLButtonElement
  readonly #speed = document.createElement('select')
  readonly #reading = document.createElement('span')
  readonly #findingButtons: readonly HTMLButtonElement[]
  readonly #stop: readonly (() => void)[]
  #run: Run | null = null
  #marks = NONE
  #counted = ''

  constructor(host: HTMLElement, cursor: Cursor) {
    this.#cursor = cursor
    this.#track = new Track(cursor)
    this.#play = button('▶', words.play, () => this.#toggle())
    this.#loop = button('⟳', words.loop, () => this.#repeat())
    this.#loop.title = words.loopHint
    this.#findingButtons = [
      button('⚠◂', words.previousFinding, () =>
        this.#go(lastBefore(this.#marks.findings, cursor.time)?.time),
      ),
      button('▸⚠', words.nextFinding, () => this.#go(firstAfter(this.#marks.findings, cursor.time)?.time)),
    ]
    this.#speed.setAttribute('aria-label', words.speed)
    for (const speed of SPEEDS) this.#speed.add(new Option(words.speedOf(speed), String(speed)))
    this.#speed.addEventListener('change', () => cursor.setSpeed(Number(this.#speed.value)))
    this.#reading.className = 'timeline-reading'
    this.#element.className = 'timeline'
    this.#element.setAttribute('role', 'group')
    this.#element.setAttribute('aria-label', words.timeline)
    this.#element.append(
      button('◂|', words.previousStep, () => this.#stepBack()),
      this.#play,
      button('|▸', words.nextStep, () => this.#stepOn()),
      this.#track.element,
      this.#reading,
      ...this.#findingButtons,
      this.#loop,
      this.#speed,
    )
    this.#track.element.addEventListener('keydown', event => {
      if (this.key(event)) event.preventDefault()
    })
    host.append(this.#element)
    this.#stop = [cursor.onTime(() => this.#follow()), cursor.onChange(() => this.#changed())]
    this.#changed()
  }

  /** Show the marks of a run, or none; call it again when a finished run takes its place. */
  show(run: Run | null): void {
    this.#run = run
    this.#counted = ''
    this.#changed()
  }

  /**
   * Do what a key means on the timeline and return whether it meant something: space, ←/→ one step,
   * Shift+←/→ one finding, Page Up/Down one second, Home/End, [ and ] for the repeated stretch.
   */
  key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false
    const { time, end, loop } = this.#cursor
    const finding = event.shiftKey
    switch (event.key) {
      case ' ':
        this.#toggle()
        return true
      case 'ArrowRight':
        if (finding) this.#go(firstAfter(this.#marks.findings, time)?.time)
        else this.#stepOn()
        return true
      case 'ArrowLeft':
        if (finding) this.#go(lastBefore(this.#marks.findings, time)?.time)
        else this.#stepBack()
        return true
      case 'PageUp':
        this.#go(time + 1)
        return true
      case 'PageDown':
        this.#go(time - 1)
        return true
      case 'Home':
        this.#go(0)
        return true
      case 'End':
        this.#go(end)
        return true
      case '[':
        this.#cursor.setLoop([time, Math.max(loop?.[1] ?? end, time)])
        return true
      case ']':
        this.#cursor.setLoop([Math.min(loop?.[0] ?? 0, time), time])
        return true
      default:
        return false
    }
  }

  destroy(): void {
    for (const stop of this.#stop) stop()
    this.#track.destroy()
    this.#element.remove()
  }

  #toggle(): void {
    if (this.#cursor.playing) this.#cursor.pause()
    else this.#cursor.play()
  }

  #repeat(): void {
    this.#cursor.setLoop(this.#cursor.loop ? null : [0, this.#cursor.end])
  }

  #stepOn(): void {
    this.#go(firstAfter(this.#marks.steps, this.#cursor.time)?.time ?? this.#cursor.end)
  }

  #stepBack(): void {
    this.#go(lastBefore(this.#marks.steps, this.#cursor.time)?.time ?? 0)
  }

  #go(time: number | undefined): void {
    if (time === undefined) return
    this.#cursor.pause()
    this.#cursor.seek(time)
  }

  #follow(): void {
    this.#reading.textContent = words.reading(this.#cursor.time, this.#cursor.end)
    this.#track.follow()
  }

  #changed(): void {
    const { playing, loop, speed } = this.#cursor
    this.#remark()
    this.#play.textContent = playing ? '❚❚' : '▶'
    this.#play.setAttribute('aria-label', playing ? words.pause : words.play)
    this.#play.title = playing ? words.pause : words.play
    this.#loop.setAttribute('aria-pressed', String(loop !== null))
    this.#speed.value = String(speed)
    this.#track.relate()
    this.#follow()
  }

  /** Take new events of a live run into the marks. */
  #remark(): void {
    const run = this.#run
    const counted = run ? `${run.events.length} ${run.findings.length}` : ''
    if (counted === this.#counted && run) return
    this.#counted = counted
    this.#marks = run ? marksOf(run) : NONE
    for (const one of this.#findingButtons) one.disabled = this.#marks.findings.length === 0
    this.#track.show(this.#marks)
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
