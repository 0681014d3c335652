/** The tasks that an operator chooses: steps as they are typed, and what the server says of each of them. */
import type { Command } from '../wire/commands'
import type { ProgramPoint, StepState, TaskList, TasksChecked, TasksEstimated } from '../wire/messages'
import { blankFields } from './blank_fields'
import { type ChosenStep, keptSteps } from './chosen_step'
import type { UndoStack } from './undo'

export interface TaskWires {
  /** False when it could not be sent. */
  readonly send: (command: Command) => boolean
  /** Draw the points of the program; `selected` is the place of one in the list, -1 for none. */
  readonly show: (points: readonly ProgramPoint[], selected: number) => void
  /** Keep the steps for the next time. */
  readonly keep: (steps: readonly ChosenStep[]) => void
  readonly undo: UndoStack
}

export class ChosenTasks {
  readonly #wires: TaskWires
  readonly #listeners = new Set<() => void>()
  readonly #states = new Map<number, StepState>()
  readonly #left = new Set<string>()
  #list: TaskList | null = null
  #steps: readonly ChosenStep[] = []
  #answer: TasksChecked | null = null
  #estimate: TasksEstimated | null = null
  #selected = -1
  #point = -1
  #before: readonly ChosenStep[] | null = null
  #nextKey = 1
  #id = 0
  #outstanding: { readonly id: number; readonly keys: readonly number[] } | null = null
  #waiting = false
  #problem = ''
  #open = false
  #shown = false

  constructor(wires: TaskWires) {
    this.#wires = wires
  }

  /** What may be chosen; null until the server has said it. */
  get list(): TaskList | null {
    return this.#list
  }

  /** Why the tasks are not known, or the steps not checked, now; empty where they are. */
  get problem(): string {
    return this.#problem
  }

  get steps(): readonly ChosenStep[] {
    return this.#steps
  }

  /** What was said last, perhaps of steps that have changed since; null before. */
  get answer(): TasksChecked | null {
    return this.#answer
  }

  /** Whether what was said last is said of the steps as they stand. */
  get settled(): boolean {
    return this.#answer !== null && this.#outstanding === null && !this.#waiting
  }

  /** How long the program takes; null while it is not known. */
  get estimate(): TasksEstimated | null {
    return this.#estimate?.id === this.#answer?.id ? this.#estimate : null
  }

  /** Key of the step whose world is shown; -1 for the start. */
  get selected(): number {
    return this.#selected
  }

  /** Place of the point that is highlighted; -1 for none. */
  get point(): number {
    return this.#point
  }

  /** What was said last of a step; null before. */
  stateOf(key: number): StepState | null {
    return this.#states.get(key) ?? null
  }

  /** The words of the fields of a step that have to be filled in, none of which anybody has left blank yet. */
  unfilled(step: ChosenStep): readonly string[] {
    const task = this.#list?.tasks.find(one => one.name === step.name)
    const blank = task ? blankFields(step, task, this.#list?.places ?? []) : []
    return blank.some(one => this.#left.has(`${step.key} ${one.field}`)) ? [] : blank.map(one => one.word)
  }

  /** The keyboard has left a field of a step: blank, it is a mistake from now on. */
  leave(key: number, field: string): void {
    const left = `${key} ${field}`
    if (this.#left.has(left)) return
    this.#left.add(left)
    this.#changed()
  }

  /** The program is to be generated: every blank field is a mistake from now on. */
  leaveAll(): void {
    for (const step of this.#steps) {
      const task = this.#list?.tasks.find(one => one.name === step.name)
      for (const { field } of task ? blankFields(step, task, []) : []) this.#left.add(`${step.key} ${field}`)
    }
    this.#changed()
  }

  onChange(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Ask for the tasks, once; steps of an earlier visit come back. */
  open(kept: unknown): void {
    if (this.#open) return
    this.#open = true
    this.#steps = keptSteps(kept)
    this.#nextKey = 1 + Math.max(0, ...this.#steps.map(one => one.key))
    this.renew()
  }

  /** Draw the points of the program from now on. */
  showPoints(): void {
    this.#shown = true
    this.#draw()
  }

  hidePoints(): void {
    this.#shown = false
    this.#draw()
  }

  /** Ask for everything anew: another cell, another connection. */
  renew(): void {
    if (!this.#open) return
    this.#outstanding = null
    this.#wires.send({ type: 'open_tasks' })
    this.#check()
  }

  /** Ask for everything anew after a problem. */
  retry(): void {
    this.#problem = ''
    this.renew()
    this.#changed()
  }

  add(name: string, way: string): void {
    const task = this.#list?.tasks.find(one => one.name === name)
    const passed = task?.parameters.filter(one => !one.told) ?? []
    const step: ChosenStep = {
      key: this.#nextKey++,
      name,
      points: passed.filter(one => one.kind === 'location').map(() => ''),
      values: passed.filter(one => one.kind !== 'location').map(one => one.default),
    }
    const at = this.#steps.findIndex(one => one.key === this.#selected)
    const place = at < 0 ? this.#steps.length : at + 1
    this.#selected = step.key
    this.#do(way, [...this.#steps.slice(0, place), step, ...this.#steps.slice(place)])
  }

  remove(key: number, way: string): void {
    this.#do(
      way,
      this.#steps.filter(one => one.key !== key),
    )
  }

  clear(way: string): void {
    this.#do(way, [])
  }

  /** Move a step up (-1) or down (1). */
  move(key: number, by: -1 | 1, way: string): void {
    const at = this.#steps.findIndex(one => one.key === key)
    const other = this.#steps[at + by]
    const step = this.#steps[at]
    if (!step || !other) return
    this.#do(
      way,
      this.#steps.map(one => (one === step ? other : one === other ? step : one)),
    )
  }

  /** Change a step while it is typed; `commit` closes the gesture. */
  edit(key: number, change: Partial<Omit<ChosenStep, 'key'>>): void {
    this.#before ??= this.#steps
    this.#apply(this.#steps.map(one => (one.key === key ? { ...one, ...change } : one)))
  }

  /** What was typed is one step of undo. */
  commit(way: string): void {
    const before = this.#before
    const after = this.#steps
    this.#before = null
    if (!before || JSON.stringify(before) === JSON.stringify(after)) return
    this.#wires.undo.did({ name: way, undo: () => this.#apply(before), redo: () => this.#apply(after) })
  }

  select(key: number): void {
    if (this.#selected === key) return
    this.#selected = key
    this.#changed()
  }

  /** Highlight a point of the program, or none. */
  showPoint(place: number): void {
    this.#point = place
    this.#changed()
  }

  receiveList(list: TaskList): void {
    this.#problem = list.problem
    if (!list.problem) this.#list = list
    this.#changed()
  }

  receive(answer: TasksChecked): void {
    if (answer.id !== this.#outstanding?.id) return
    const { keys } = this.#outstanding
    this.#outstanding = null
    this.#answer = answer
    if (answer.steps.length < keys.length) this.#problem = answer.problem
    else if (this.#list) this.#problem = ''
    this.#states.clear()
    answer.steps.forEach((state, at) => {
      const key = keys[at]
      if (key !== undefined) this.#states.set(key, state)
    })
    if (this.#point >= answer.points.length) this.#point = -1
    // The project has changed on the disk: what may be chosen is told anew.
    if (this.#list && answer.revision > this.#list.revision) this.#wires.send({ type: 'open_tasks' })
    if (this.#waiting) this.#check()
    this.#changed()
  }

  receiveEstimate(estimate: TasksEstimated): void {
    this.#estimate = estimate
    this.#changed()
  }

  #do(way: string, after: readonly ChosenStep[]): void {
    const before = this.#steps
    this.#wires.undo.do({ name: way, undo: () => this.#apply(before), redo: () => this.#apply(after) })
  }

  #apply(steps: readonly ChosenStep[]): void {
    this.#steps = steps
    this.#wires.keep(steps)
    this.#check()
    this.#changed()
  }

  /** Latest wins: one question is out, the newest steps wait. */
  #check(): void {
    this.#waiting = this.#outstanding !== null
    if (this.#waiting) return
    const id = ++this.#id
    const steps = this.#steps.map(({ name, points, values }) => ({ name, points, values }))
    if (this.#wires.send({ type: 'check_tasks', id, steps })) {
      this.#outstanding = { id, keys: this.#steps.map(one => one.key) }
    }
  }

  #draw(): void {
    this.#wires.show(this.#shown ? (this.#answer?.points ?? []) : [], this.#point)
  }

  #changed(): void {
    this.#draw()
    for (const listener of [...this.#listeners]) listener()
  }
}
