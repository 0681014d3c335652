/** Going through a run: play and pause, from step to step, from finding to finding, the repeated stretch. */
import type { Cursor } from './cursor'
import { type Lane, lanesOf } from './lanes'
import { firstAfter, lastBefore, type Marks, marksOf, NO_MARKS } from './marks'
import type { Run } from './run'

export type TransportKey = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'> &
  Partial<Pick<KeyboardEvent, 'getModifierState'>>

/** What play and pause act on where it is not the cursor: a live run. */
export interface Player {
  readonly playing: boolean
  toggle(): void
}

/** Page Up and Page Down go this far [s]. */
const PAGE = 1

export class Transport {
  readonly cursor: Cursor
  #run: Run | null = null
  #player: Player | null = null
  #marks = NO_MARKS
  #lanes: readonly Lane[] = []
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

  /** The lanes of the run, made with the marks. */
  get lanes(): readonly Lane[] {
    return this.#lanes
  }

  show(run: Run | null): void {
    this.#run = run
    this.#marks = run ? marksOf(run) : NO_MARKS
    this.#lanes = run ? lanesOf(run, this.#marks) : []
    this.#counted = run?.events.length ?? 0
  }

  /** Play and pause act on this from now on, on the cursor again where it is null. */
  drive(player: Player | null): void {
    this.#player = player
  }

  get playing(): boolean {
    return this.#player?.playing ?? this.cursor.playing
  }

  toggle(): void {
    if (this.#player) this.#player.toggle()
    else if (this.cursor.playing) this.cursor.pause()
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
   * Do what a key means on the timeline and return whether it meant something: space, ←/→ or , and . one step,
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
    '.': () => this.nextStep(),
    ',': () => this.previousStep(),
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
