/** Numbers of the state at the cursor: time, TCP in W, joints. */
import { POSE, put, ride } from '../run/pose'
import type { Run } from '../run/run'
import type { Pose, SceneDescription } from '../scene/description'
import { jointName } from '../units/names'
import { formatQuantity } from '../units/quantity'
import { element } from './elements'
import { words } from './words'

interface Row {
  readonly value: HTMLElement
  readonly text: (time: number) => string
}

const AXES = ['x', 'y', 'z'] as const

export class Readout {
  readonly element = element('dl', { class: 'replay-values' })
  readonly #rows: Row[] = []
  readonly #run: Run
  readonly #base: Pose
  readonly #place = new Float32Array(2 * POSE)

  constructor(run: Run, scene: SceneDescription) {
    this.#run = run
    this.#base = scene.base
    this.#row(words.time, time => formatQuantity(time, 's'))
    for (const [k, axis] of AXES.entries()) {
      this.#row(`${words.tcp} ${axis}`, time => formatQuantity(this.#tcp(time)[k] ?? Number.NaN, 'm'))
    }
    for (const [k, joint] of scene.robot.joints.entries()) {
      const unit = joint.type === 'revolute' ? 'rad' : 'm'
      this.#row(jointName(joint.name), time => formatQuantity(run.value('q', k, time), unit))
    }
  }

  show(time: number): void {
    for (const { value, text } of this.#rows) {
      const next = text(time)
      if (value.textContent !== next) value.textContent = next
    }
  }

  /** The same for people who listen. */
  spoken(time: number): string {
    const [x = '', y = '', z = ''] = [...this.#tcp(time)].map(value => formatQuantity(value, 'm'))
    return words.spoken(x, y, z)
  }

  #tcp(time: number): Float32Array {
    const [x = 0, y = 0, z = 0] = AXES.map((_, k) => this.#run.value('attained_position', k, time))
    put(this.#place, 0, this.#base)
    ride(this.#place, 1, 0, [x, y, z, 1, 0, 0, 0])
    return this.#place.subarray(POSE, POSE + 3)
  }

  #row(name: string, text: (time: number) => string): void {
    const value = element('dd')
    this.element.append(element('div', {}, element('dt', {}, name), value))
    this.#rows.push({ value, text })
  }
}
