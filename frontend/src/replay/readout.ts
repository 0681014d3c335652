/** Numbers of the state at the cursor: time, TCP in W, joints. */
import { POSE, put, ride } from '../run/pose'
import type { Run } from '../run/run'
import { channelOf, labelled } from '../run/station'
import type { SceneDescription, StationDescription } from '../scene/description'
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
  readonly element = element('div', { class: 'replay-values' })
  /** Where rows are added. */
  #list = element('dl')
  readonly #rows: Row[] = []
  readonly #run: Run
  readonly #stations: readonly StationDescription[]
  readonly #place = new Float32Array(2 * POSE)

  constructor(run: Run, scene: SceneDescription) {
    this.#run = run
    this.#stations = scene.stations
    this.element.append(this.#list)
    this.#row(words.time, time => formatQuantity(time, 's'))
    for (const station of scene.stations) this.#addStation(station)
  }

  #addStation(station: StationDescription): void {
    if (this.#stations.length > 1) {
      this.#list = element('dl')
      this.element.append(element('h4', {}, station.name), this.#list)
    }
    const q = channelOf('q', station.name)
    for (const [k, axis] of AXES.entries()) {
      const value = (time: number) => this.#tcp(station, time)[k] ?? Number.NaN
      this.#row(`${words.tcp} ${axis}`, time => formatQuantity(value(time), 'm'))
    }
    for (const [k, joint] of station.joints.entries()) {
      const unit = joint.type === 'revolute' ? 'rad' : 'm'
      this.#row(jointName(joint.name), time => formatQuantity(this.#run.value(q, k, time), unit))
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
    const texts = this.#stations.map(station => {
      const [x = '', y = '', z = ''] = [...this.#tcp(station, time)].map(value => formatQuantity(value, 'm'))
      return labelled(this.#stations, station.name, words.spoken(x, y, z))
    })
    return texts.join('; ')
  }

  #tcp({ name, base }: StationDescription, time: number): Float32Array {
    const position = channelOf('attained_position', name)
    const [x = 0, y = 0, z = 0] = AXES.map((_, k) => this.#run.value(position, k, time))
    put(this.#place, 0, base)
    ride(this.#place, 1, 0, [x, y, z, 1, 0, 0, 0])
    return this.#place.subarray(POSE, POSE + 3)
  }

  #row(name: string, text: (time: number) => string): void {
    const value = element('dd')
    this.#list.append(element('div', {}, element('dt', {}, name), value))
    this.#rows.push({ value, text })
  }
}
