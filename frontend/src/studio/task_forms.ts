/** The form of a task while it is filled in, and what the server says of each field. */
import type { Command, FormParameterFields, TaskFormFields } from '../wire/commands'
import type { FormFault, TaskFormChecked, TaskFormOpened } from '../wire/messages'

export interface FormWires {
  /** False when it could not be sent. */
  readonly send: (command: Command) => boolean
}

export const EMPTY_FORM: TaskFormFields = {
  name: '',
  doc: '',
  parameters: [
    { name: 'L', kind: 'location', default: '', word: 'place', sentence: '', bounds: [], called: '' },
  ],
  needs: [],
  effects: [],
  geometry: ['reachable(arm, L)'],
  body: 'mov l',
}

export class TaskForms {
  readonly #wires: FormWires
  readonly #listeners = new Set<() => void>()
  #form: TaskFormFields | null = null
  #task = ''
  #document = ''
  #kinds: readonly string[] = []
  #problem = ''
  #checked: TaskFormChecked | null = null
  #id = 0
  #outstanding = 0
  #waiting = false
  #asked = ''

  constructor(wires: FormWires) {
    this.#wires = wires
  }

  /** The fields; null where no form is open. */
  get form(): TaskFormFields | null {
    return this.#form
  }

  /** Name of the task that is changed; empty for a new one. */
  get task(): string {
    return this.#task
  }

  /** Text of the project in which the task is, or is to be. */
  get document(): string {
    return this.#document || `kb/${this.#form?.name ?? ''}.pl`
  }

  get kinds(): readonly string[] {
    return this.#kinds
  }

  /** Why a task that was asked for has no form; empty where it has. */
  get problem(): string {
    return this.#problem
  }

  /** Whether something has been asked of the fields, answered or not. */
  get asked(): boolean {
    return this.#checked !== null || this.#outstanding !== 0
  }

  /** What was said last; null before. */
  get checked(): TaskFormChecked | null {
    return this.#checked
  }

  /** Whether what was said last is said of the fields as they stand, and nothing stands against them. */
  get good(): boolean {
    const { text, faults } = this.#checked ?? { text: '', faults: [] }
    return (
      this.#outstanding === 0 &&
      !this.#waiting &&
      text !== '' &&
      faults.every(one => one.severity !== 'error')
    )
  }

  /** What is said of a field; of several of its kind only of one of them where `place` is given. */
  faults(fields: readonly string[], place = -1): readonly FormFault[] {
    const all = this.#checked?.faults ?? []
    return all.filter(
      one => fields.includes(one.field) && (place < 0 || one.place < 0 || one.place === place),
    )
  }

  onChange(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Ask for the form of a task. */
  open(task: string): void {
    this.#asked = task
    this.#wires.send({ type: 'open_task_form', task })
  }

  /** Begin a new task; nothing is said of it before something is typed. */
  begin(kinds: readonly string[]): void {
    this.#asked = ''
    this.#show('', '', EMPTY_FORM, kinds)
    this.#changed()
  }

  close(): void {
    this.#form = null
    this.#forget()
    this.#changed()
  }

  receive(opened: TaskFormOpened): void {
    if (opened.task !== this.#asked) return
    this.#problem = opened.problem
    if (opened.form) {
      this.#show(opened.task, opened.document, opened.form, opened.kinds)
      this.#check()
    }
    this.#changed()
  }

  receiveChecked(checked: TaskFormChecked): void {
    if (checked.id !== this.#outstanding) return
    this.#outstanding = 0
    this.#checked = checked
    if (this.#waiting) this.#check()
    this.#changed()
  }

  edit(change: Partial<TaskFormFields>): void {
    if (!this.#form) return
    this.#form = { ...this.#form, ...change }
    this.#check()
    this.#changed()
  }

  editParameter(place: number, change: Partial<FormParameterFields>): void {
    const parameters = this.#form?.parameters ?? []
    this.edit({ parameters: parameters.map((one, at) => (at === place ? { ...one, ...change } : one)) })
  }

  #show(task: string, document: string, form: TaskFormFields, kinds: readonly string[]): void {
    this.#task = task
    this.#document = document
    this.#form = form
    this.#kinds = kinds
    this.#forget()
  }

  /** What was said, or is on its way, is said of other fields. */
  #forget(): void {
    this.#checked = null
    this.#problem = ''
    this.#outstanding = 0
    this.#waiting = false
  }

  /** Latest wins: one question is out, the newest fields wait. */
  #check(): void {
    const form = this.#form
    this.#waiting = this.#outstanding !== 0
    if (this.#waiting || !form) return
    const id = ++this.#id
    const [document, task] = [this.document, this.#task]
    if (this.#wires.send({ type: 'check_task_form', id, document, task, form })) this.#outstanding = id
  }

  #changed(): void {
    for (const listener of [...this.#listeners]) listener()
  }
}
