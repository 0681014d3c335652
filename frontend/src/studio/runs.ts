/** The run that the page shows: the newest good recording, or the live run while there is one. */
import { LiveRun } from '../run/live_run'
import { Pace } from '../run/pace'
import { RecordedRun } from '../run/recorded_run'
import type { Run } from '../run/run'
import type { SceneDescription } from '../scene/description'
import { words } from '../text/messages'
import { ask } from '../wire/entry'
import { decodeFrame } from '../wire/frame'
import type { Happened, LiveLayout, Placed, RunWays, SignalStamped } from '../wire/messages'
import { NOW, type RunAge, type Texts } from './run_lines'

export interface RunWires {
  /** Another run is shown from now on. */
  readonly onRun: (run: Run, of: RunTexts) => void
  /** More is told of the run that is shown. */
  readonly onTold: (run: Run, of: RunTexts) => void
  /** The live run has grown. */
  readonly onGrown: (run: Run) => void
  readonly onTrouble: (text: string) => void
}

/** Which run it is, and of which texts. */
export interface RunTexts {
  /** Number under which the server has it; 0 for a live run and for one of commands. */
  readonly id: number
  readonly texts: Texts
  /** Of an older text: a live run stays the result where the text was changed beside it. */
  readonly age: RunAge
  /** Name of the program that ran; empty for commands. */
  readonly program: string
  /** Of a program, or of commands that were typed one by one. */
  readonly of: 'program' | 'commands'
}

export class Runs {
  readonly #wires: RunWires
  #scene: SceneDescription | null = null
  #run: Run | null = null
  #recorded: RecordedRun | null = null
  #live: LiveRun | null = null
  /** A pack that came before the scene. */
  #early: ArrayBuffer | null = null
  #newest = 0
  /** What is said of a run whose ways have been looked at, which may not be here yet. */
  #ways: RunWays | null = null
  /** The run that is on its way, and the one that is shown. */
  #wanted: RunTexts = { id: 0, texts: NOW, age: 'newest', program: '', of: 'program' }
  #shown = this.#wanted
  #frames = 0
  #latency = Number.NaN
  readonly #pace = new Pace()

  constructor(wires: RunWires) {
    this.#wires = wires
  }

  get run(): Run | null {
    return this.#run
  }

  /** Number under which the server has the shown run; 0 for none, a live one and one of commands. */
  get id(): number {
    return this.#shown.id
  }

  /** Frames of the live run that came, and how old the last one was when it came [ms]. */
  get frames(): number {
    return this.#frames
  }

  get latency(): number {
    return this.#latency
  }

  /** Simulated seconds per second of the live run, as it really goes; null while that is not known. */
  get pace(): number | null {
    return this.#pace.value
  }

  /** Another pace is wanted: what was measured says nothing of it. */
  forgetPace(): void {
    this.#pace.reset()
  }

  /** Bodies are those of this scene from now on. */
  setScene(scene: SceneDescription): void {
    this.#scene = scene
    this.#recorded?.showIn(scene)
    this.#live?.showIn(scene)
    const early = this.#early
    this.#early = null
    if (early) void this.#take(this.#newest, async () => early)
  }

  /** A run is done: fetch it and show it, unless a newer one is done before it is here. */
  async take(id: number, texts: Texts = NOW, age: RunAge = 'newest', program = ''): Promise<void> {
    this.#wanted = { id, texts, age, program, of: 'program' }
    await this.#take(++this.#newest, () => fetchPack('run', id))
  }

  /** The robot of the command line has carried out a command: fetch the run of all and show it. */
  async takeCommands(id: number): Promise<void> {
    this.#wanted = { id: 0, texts: NOW, age: 'newest', program: '', of: 'commands' }
    await this.#take(++this.#newest, () => fetchPack('told', id))
  }

  /** The ways of a run have been looked at: it is shown with what is said of it now. */
  see(ways: RunWays): void {
    this.#ways = ways
    const run = this.#recorded
    if (!run || run !== this.#run || this.#shown.id !== ways.run) return
    run.tell(ways.findings, ways.result, ways.ways)
    this.#wires.onTold(run, this.#shown)
  }

  async #take(order: number, fetch: () => Promise<ArrayBuffer>): Promise<void> {
    try {
      const bytes = await fetch()
      if (order === this.#newest) await this.#decode(bytes, order)
    } catch (error) {
      if (order === this.#newest)
        this.#wires.onTrouble(error instanceof Error ? error.message : String(error))
    }
  }

  startLive(layout: LiveLayout, texts: Texts = NOW, program = ''): void {
    if (!this.#scene) return
    this.#newest += 1
    this.#live = new LiveRun(this.#scene, layout)
    this.#frames = 0
    this.#pace.reset()
    this.#show(this.#live, { id: 0, texts, age: 'newest', program, of: 'program' })
  }

  place(placed: Placed): void {
    this.#live?.place(placed)
  }

  stamp(stamped: SignalStamped): void {
    this.#live?.stamp(stamped)
  }

  happen(happened: Happened): void {
    this.#live?.happen(happened)
  }

  frame(bytes: ArrayBuffer): void {
    const frame = decodeFrame(bytes)
    if (!frame || !this.#live) return
    this.#live.add(frame)
    this.#frames += 1
    this.#latency = Date.now() - frame.wall
    this.#pace.add(frame.time, frame.wall)
    if (this.#run === this.#live) this.#wires.onGrown(this.#live)
  }

  async #decode(bytes: ArrayBuffer, order: number): Promise<void> {
    const scene = this.#scene
    if (!scene) {
      this.#early = bytes
      return
    }
    const run = await RecordedRun.decode(bytes, scene)
    if (order !== this.#newest) return
    // Another scene may have come while the pack was unpacked.
    if (this.#scene && this.#scene !== scene) run.showIn(this.#scene)
    const ways = this.#ways
    if (ways?.run === this.#wanted.id) run.tell(ways.findings, ways.result, ways.ways)
    this.#recorded = run
    this.#live = null
    this.#show(run, this.#wanted)
  }

  #show(run: Run, shown: RunTexts): void {
    this.#run = run
    this.#shown = shown
    this.#wires.onRun(run, shown)
  }
}

async function fetchPack(kind: 'run' | 'told', id: number): Promise<ArrayBuffer> {
  const answer = await ask(`/${kind}/${id}.pack`)
  if (!answer.ok) throw new Error(words.run.gone(answer.status))
  return answer.arrayBuffer()
}
