/** The robot of a station moved by hand: joint coordinates or a TCP pose go to the real kinematics, its answer is shown. */
import type { JointDescription, Pose, StationDescription } from '../scene/description'
import type { Command } from '../wire/commands'
import type { Jogged } from '../wire/messages'
import type { UndoStack } from './undo'

export interface JogWires {
  /** False when it could not be sent. */
  readonly send: (command: Command) => boolean
  /** Draw the jogged arm; null for none. */
  readonly show: (answer: Jogged | null) => void
  readonly undo: UndoStack
}

export class Jog {
  readonly #wires: JogWires
  readonly #listeners = new Set<() => void>()
  #stations: readonly StationDescription[] = []
  #station = ''
  #q: readonly number[] | null = null
  #answer: Jogged | null = null
  #before: readonly number[] | null = null
  #nextId = 1
  #outstanding = 0
  #waiting: ((id: number) => Command) | null = null

  constructor(wires: JogWires) {
    this.#wires = wires
  }

  /** Joint coordinates that are wanted [rad | m]; null while nothing is jogged. */
  get q(): readonly number[] | null {
    return this.#q
  }

  /** What the kinematics said last. */
  get answer(): Jogged | null {
    return this.#answer
  }

  /** An answer is on its way. */
  get busy(): boolean {
    return this.#outstanding !== 0 || this.#waiting !== null
  }

  /** A gesture is under way: something has moved since the last `commit`. */
  get moving(): boolean {
    return this.#before !== null
  }

  get stations(): readonly StationDescription[] {
    return this.#stations
  }

  /** Name of the station whose robot is moved, or was moved last; empty for none. */
  get station(): string {
    return this.#station
  }

  get joints(): readonly JointDescription[] {
    return this.#of(this.#station)?.joints ?? []
  }

  onChange(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** The stations of the cell; another robot ends jogging. */
  setStations(stations: readonly StationDescription[]): void {
    this.#stations = stations
    if (!this.#q) return
    if (this.#q.length === this.joints.length) this.#ask(this.#q)
    else this.stop()
  }

  /** Begin with the robot of a station at these joint coordinates, or go there; those of other joints are left out. */
  start(station: string, q: readonly number[]): void {
    const count = this.#of(station)?.joints.length ?? 0
    if (q.length === 0 || q.length !== count || q.some(one => !Number.isFinite(one))) return
    if (station !== this.#station) {
      if (this.#q) this.stop()
      // What was asked for the other robot is not answered to this one.
      this.#outstanding = 0
      this.#station = station
    }
    this.#ask(q)
  }

  stop(): void {
    this.#q = null
    this.#answer = null
    this.#waiting = null
    this.#before = null
    this.#wires.show(null)
    this.#changed()
  }

  /** Move one joint [rad | m]; `commit` closes the gesture. */
  moveJoint(joint: number, value: number): void {
    if (!this.#q || !Number.isFinite(value)) return
    this.#before ??= this.#q
    this.#ask(this.#q.map((one, at) => (at === joint ? value : one)))
  }

  /** Bring the TCP to a pose in W, on the branch nearest to where the arm stands. */
  moveTcp(target: Pose): void {
    const q = this.#answer?.q ?? this.#q
    if (!q) return
    this.#before ??= q
    const station = this.#station
    const tool = this.#of(station)?.tool ?? ''
    this.#request(id => ({ type: 'jog_tcp', id, station, q: this.#answer?.q ?? q, tool, target }))
  }

  /** What was asked for last is given up: ask for where the arm stands, so that what is said is of that. */
  settle(): void {
    const q = this.#answer?.q ?? this.#q
    if (this.#q && q && this.#answer?.reached === false) this.#ask(q)
  }

  /** A gesture has ended: keep the way back under a name. */
  commit(name: string): void {
    const from = this.#before
    this.#before = null
    if (!from || !this.#q) return
    if (this.#outstanding || this.#waiting) {
      // The answer to a TCP target decides where the arm stands; wait for it.
      const stop = this.onChange(() => {
        if (this.#outstanding || this.#waiting) return
        stop()
        this.#keep(name, from)
      })
      return
    }
    this.#keep(name, from)
  }

  receive(answer: Jogged): void {
    if (answer.id !== this.#outstanding) return
    this.#outstanding = 0
    if (this.#q) {
      this.#answer = answer
      if (!this.#waiting) this.#q = answer.q
      this.#wires.show(answer)
    }
    this.#next()
    this.#changed()
  }

  /** The connection is new: nothing is on its way any more. */
  reconnected(): void {
    this.#outstanding = 0
    if (this.#q) this.#ask(this.#q)
  }

  #of(station: string): StationDescription | undefined {
    return this.#stations.find(one => one.name === station)
  }

  #keep(name: string, from: readonly number[]): void {
    const to = this.#q
    if (!to || to.every((one, at) => one === from[at])) return
    const station = this.#station
    this.#wires.undo.did({
      name,
      undo: () => this.start(station, from),
      redo: () => this.start(station, to),
    })
  }

  #ask(q: readonly number[]): void {
    this.#q = q
    const station = this.#station
    const tool = this.#of(station)?.tool ?? ''
    this.#request(id => ({ type: 'jog_joints', id, station, q, tool }))
    this.#changed()
  }

  /** Latest wins: one request is out, the newest of the others waits. */
  #request(command: (id: number) => Command): void {
    this.#waiting = command
    if (!this.#outstanding) this.#next()
  }

  #next(): void {
    const command = this.#waiting
    if (!command) return
    this.#waiting = null
    const id = this.#nextId++
    if (this.#wires.send(command(id))) this.#outstanding = id
  }

  #changed(): void {
    for (const listener of [...this.#listeners]) listener()
  }
}
