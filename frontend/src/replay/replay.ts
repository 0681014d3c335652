/** The replay of a run: views, timeline, program, findings, state and a plot around one time cursor. */
import { Cursor } from '../run/cursor'
import type { RecordedRun } from '../run/recorded_run'
import type { RunEvent } from '../run/run'
import { Timeline } from '../run/timeline'
import { Transport } from '../run/transport'
import type { SceneDescription } from '../scene/description'
import { embeddedMesh } from './data'
import { element, panel } from './elements'
import { findingsList } from './findings_list'
import { Picture } from './picture'
import { PlotChoice } from './plot_choice'
import { ProgramChoice } from './program_choice'
import { Readout } from './readout'
import { nextPass } from './steps'
import { words } from './words'

/** Numbers change this often, pictures at every frame [ms]. */
const PERIOD = 100
/** Spoken text follows so long after a change, and changes no more often [ms]. */
const SPEECH = 1000

export class Replay {
  readonly cursor = new Cursor()
  readonly picture: Picture
  readonly #readout: Readout
  readonly #programs: ProgramChoice
  readonly #passes = element('p', { class: 'replay-quiet', role: 'status' })
  readonly #transport = new Transport(this.cursor)
  #ghostUntil: number | null = null
  #frame = 0
  #last: number | null = null
  #written = Number.NEGATIVE_INFINITY
  #speech: ReturnType<typeof setTimeout> | null = null

  constructor(
    host: HTMLElement,
    run: RecordedRun,
    scene: SceneDescription,
    texts: Readonly<Record<string, string>>,
  ) {
    this.picture = new Picture(run, scene, embeddedMesh)
    const bar = element('div', { class: 'replay-timeline' })
    host.append(bar)
    this.cursor.setEnd(run.duration)
    this.#transport.show(run)
    new Timeline(bar, this.#transport, 'with Ctrl')
    this.#programs = new ProgramChoice(run, texts, (line, steps) => this.#choose(line, steps))
    this.#passes.textContent = words.programHint
    this.#readout = new Readout(run, scene)
    const plot = panel(words.plot, 'replay-curve')
    host.append(
      element(
        'div',
        { class: 'replay-panels' },
        panel(words.program, 'replay-text', ...this.#programs.elements, this.#passes),
        panel(words.values, 'replay-state', this.#readout.element),
        panel(
          words.findings,
          'replay-found',
          findingsList(run.findings, run.stations.length > 1 ? 'named' : 'known', (time, place) => {
            this.#go(time)
            if (place) this.picture.stage.frame([...place])
          }),
        ),
        plot,
      ),
    )
    new PlotChoice(plot, run, this.cursor)
    host.addEventListener('keydown', event => this.#key(event))
    this.cursor.onTime(() => this.#wake())
    this.cursor.onChange(() => this.#wake())
    this.show()
  }

  /** Show everything at the time of the cursor now. */
  show(): void {
    const { time } = this.cursor
    this.picture.show(time)
    this.#write(time)
  }

  #choose(line: number, passes: readonly RunEvent[]): void {
    const pass = nextPass(passes, this.cursor.time)
    const step = passes[pass]
    if (!step) return
    this.#go(step.time)
    // A step without motion ends where it began: its ghost would only cover the arm.
    if (step.kind === 'move') this.#showGhost(step.time + step.duration)
    this.#passes.textContent = `${words.line(line)} ${words.pass(pass + 1, passes.length)}`
  }

  #go(time: number): void {
    this.#showGhost(null)
    this.#transport.go(time)
  }

  #showGhost(time: number | null): void {
    this.picture.ghost(time)
    this.#ghostUntil = time
  }

  #wake(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(now => this.#step(now))
  }

  #step(now: number): void {
    this.#frame = 0
    const { cursor } = this
    const passed = this.#last === null ? 0 : Math.min(now - this.#last, 250) / 1000
    this.#last = cursor.playing ? now : null
    cursor.advance(passed)
    if (this.#ghostUntil !== null && cursor.time >= this.#ghostUntil) this.#showGhost(null)
    this.picture.show(cursor.time)
    this.#programs.show(cursor.time)
    if (!cursor.playing || now - this.#written >= PERIOD) this.#write(cursor.time)
    if (cursor.playing) this.#wake()
  }

  #write(time: number): void {
    this.#written = performance.now()
    this.#programs.show(time)
    this.#readout.show(time)
    this.#speech ??= setTimeout(() => {
      this.#speech = null
      this.picture.stage.describe(this.#readout.spoken(this.cursor.time))
    }, SPEECH)
  }

  /** Keys that mean something on the timeline do so everywhere but in controls with keys of their own. */
  #key(event: KeyboardEvent): void {
    const target = event.target
    if (event.defaultPrevented || !(target instanceof Element)) return
    if (target.closest('button, select, input, [role="slider"]')) return
    if (this.#transport.key(event)) event.preventDefault()
  }
}
