/** Going through a run: play and pause, from step to step, from finding to finding, the repeated stretch. */
import type { Cursor } from './cursor'
import { firstAfter, lastBefore, type Marks, marksOf, NO_MARKS } from './marks'
import type { Run } from './run'

export type TransportKey = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'> &
  Partial<Pick<KeyboardEvent, 'getModifierState'>>

/** Page Up and Page Down go this far [s]. */
const PAGE = 1

export class Transport {
  readonly cursor: Cursor
  #run: Run | null = null
  #marks = NO_MARKS
  /** Events of the run that are in the marks. */
  #counted = 0

  constructor(cursor: Cursor) {
    this.cursor = cursor
  }

  /** What is to be marked in the run; the same object until a live run has more. */
  get marks(): Marks {
    if (this.#run && this.#run.events.length !== this.#counted) this.show(this.#run)
    return this.#marks
  }

  show(run: Run | null): void {
    this.#run = run
    this.#marks = run ? marksOf(run) : NO_MARKS
    this.#counted = run?.events.length ?? 0
  }

  toggle(): void {
    if (this.cursor.playing) this.cursor.pause()
    else this.cursor.play()
  }

  /** Stop at a time [s]. */
  go(time: number): void {
    this.cursor.pause()
    this.cursor.seek(time)
  }

  nextStep(): void {
    this.go(firstAfter(this.marks.steps, this.cursor.time)?.time ?? this.cursor.end)
  }

  previousStep(): void {
    this.go(lastBefore(this.marks.steps, this.cursor.time)?.time ?? 0)
  }

  nextFinding(): void {
    const found = firstAfter(this.marks.findings, this.cursor.time)
    if (found) this.go(found.time)
  }

  previousFinding(): void {
    const found = lastBefore(this.marks.findings, this.cursor.time)
    if (found) this.go(found.time)
  }

  /** Repeat the whole run, or nothing any more. */
  repeat(): void {
    this.cursor.setLoop(this.cursor.loop ? null : [0, this.cursor.end])
  }

  /** Repeat from here on. */
  repeatFrom(): void {
    const { time, end, loop } = this.cursor
    this.cursor.setLoop([time, loop && loop[1] > time ? loop[1] : end])
  }

  /** Repeat up to here. */
  repeatUntil(): void {
    const { time, loop } = this.cursor
    this.cursor.setLoop([loop && loop[0] < time ? loop[0] : 0, time])
  }

  /**
   * Do what a key means on the timeline and return whether it meant something: space, ←/→ one step,
   * Shift+←/→ one finding, Page Up/Down one second, Home/End, [ and ] for the repeated stretch.
   */
  key(event: TransportKey): boolean {
    // On many keyboards brackets are typed with AltGr, which some systems report as Ctrl+Alt.
    const typed = event.getModifierState?.('AltGraph') === true
    if (!typed && (event.ctrlKey || event.metaKey || event.altKey)) return false
    const act = this.#keys[event.shiftKey ? `Shift+${event.key}` : event.key] ?? this.#keys[event.key]
    act?.()
    return act !== undefined
  }

  readonly #keys: Readonly<Record<string, () => void>> = {
    ' ': () => this.toggle(),
    ArrowRight: () => this.nextStep(),
    ArrowLeft: () => this.previousStep(),
    'Shift+ArrowRight': () => this.nextFinding(),
    'Shift+ArrowLeft': () => this.previousFinding(),
    PageUp: () => this.go(this.cursor.time + PAGE),
    PageDown: () => this.go(this.cursor.time - PAGE),
    Home: () => this.go(0),
    End: () => this.go(this.cursor.end),
    '[': () => this.repeatFrom(),
    ']': () => this.repeatUntil(),
  }
}
