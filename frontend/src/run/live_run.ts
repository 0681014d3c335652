/** A run while it is simulated: a window of the newest frames, asked by time like a finished run. */
import type { Pose, SceneDescription } from '../scene/description'
import type { StateFrame } from '../wire/frame'
import type { Happened, LiveLayout, Placed, SignalStamped } from '../wire/messages'
import { unitsByAxes } from './column_units'
import { FrameStore } from './frame_store'
import { Placements } from './placements'
import { between, POSE } from './pose'
import type { ChannelInfo, Finding, Run, RunEvent, Series } from './run'
import { channelOf, type RunStation } from './station'
import { speedChannel, speedOf, TCP_SPEED, valueIn } from './tcp_speed'
import { type Trail, trailOf } from './trail'

interface LiveChannel extends ChannelInfo {
  readonly columns: string[]
  readonly min: number[]
  readonly max: number[]
  /** Place of its first column in a row. */
  readonly first: number
  /** Its value holds between changes. */
  readonly held: boolean
}

export class LiveRun implements Run {
  readonly live = true
  readonly stations: readonly RunStation[]
  readonly fidelity = 'dynamic'
  readonly findings: readonly Finding[] = []
  readonly channels: readonly ChannelInfo[]
  readonly events: RunEvent[] = []
  /** Poses of the base frames in W, by station. */
  readonly #bases: ReadonlyMap<string, Pose>
  /** Names of the bodies as the run counts them. */
  readonly #names: readonly string[]
  readonly #store: FrameStore
  readonly #columns: number
  /** The channels of the frames; speeds follow from them. */
  readonly #framed: readonly LiveChannel[]
  /** Places of the TCP positions in a row, by the name of the channel of its speed. */
  readonly #positions = new Map<string, readonly number[]>()
  readonly #bodies: readonly number[]
  readonly #placed: Placed[] = []
  #placements: Placements
  /** Place in the scene of each body whose poses are in the frames; -1 where the scene lacks it. */
  #places: readonly number[] = []
  #tracked = NONE
  /** Places of the tasks among the events, by station and serial. */
  readonly #tasks = new Map<string, number>()
  readonly #series = new Map<string, Series>()
  readonly #trails = new Map<string, Trail>()

  constructor(scene: SceneDescription, layout: LiveLayout) {
    this.stations = layout.stations
    this.#bases = new Map(scene.stations.map(({ name, base }) => [name, base]))
    this.#names = scene.bodies.map(body => body.name)
    this.#framed = channelsOf(layout).map(channel => {
      const axes = scene.stations.find(one => one.name === channel.subject)?.joints ?? []
      return { ...channel, units: unitsByAxes(channel, axes) }
    })
    this.channels = [...this.#framed, ...this.#speedChannels()]
    this.#columns = layout.channels.length
    this.#bodies = layout.bodies
    this.#store = new FrameStore(this.#columns + POSE * layout.bodies.length)
    this.#placements = new Placements(scene, this.#names)
    this.showIn(scene)
  }

  /** Let the bodies of another description of the cell be moved; the simulated cell stays what it was. */
  showIn(scene: SceneDescription): void {
    const placements = new Placements(scene, this.#names)
    this.#placements = placements
    this.#places = this.#bodies.map(body => placements.placeOf(body))
    this.#tracked = new Uint8Array(scene.bodies.length)
    for (const place of this.#places) if (place >= 0) this.#tracked[place] = 1
    for (const placed of this.#placed) placements.add(placed.body, placed)
  }

  get duration(): number {
    return this.#store.last
  }

  /** Take a frame in. One that does not fit the layout, or is not newer than the last, is left out. */
  add(frame: StateFrame): void {
    if (frame.values.length !== this.#columns) return
    if (!this.#store.add(frame.time, frame.values, frame.poses)) return
    this.#widen(frame.values)
    this.#series.clear()
    this.#trails.clear()
  }

  /** Let a body ride, rest or be gone from a time on. */
  place(placed: Placed): void {
    this.#placed.push(placed)
    this.#placements.add(placed.body, placed)
  }

  /** Remember the press of a key as an event. */
  stamp({ name, value, time }: SignalStamped): void {
    const data = { signal: name, value }
    const text = `${name} = ${value}`
    this.events.push({ time, duration: 0, kind: 'input', text, station: '', span: null, data })
  }

  /** Take an event; a task that goes on takes the place of what was known of it. */
  happen({ event }: Happened): void {
    const key = event.kind === 'task' ? `${event.station} ${event.data.serial}` : null
    const known = key === null ? undefined : this.#tasks.get(key)
    if (known !== undefined) this.events[known] = event
    else if (key !== null) this.#tasks.set(key, this.events.push(event) - 1)
    else this.events.push(event)
  }

  value(channel: string, column: number, time: number): number {
    const position = this.#positions.get(channel)
    if (position) return this.#speedAt(position, time)
    const found = this.#find(channel, column)
    if (!found || this.#store.count === 0) return Number.NaN
    const { place, held } = found
    const { index, share } = this.#store.locate(time)
    const from = this.#store.at(index, place)
    if (share === 0 || held) return from
    return from + (this.#store.at(index + 1, place) - from) * share
  }

  series(channel: string, column: number): Series | undefined {
    const key = `${channel} ${column}`
    const known = this.#series.get(key)
    if (known) return known
    const position = this.#positions.get(channel)
    const found = this.#find(channel, column)
    const made = position
      ? speedOf(position.map(place => this.#rows(place)))
      : found && { ...this.#rows(found.place), held: found.held }
    if (made) this.#series.set(key, made)
    return made
  }

  bodies(time: number, poses: Float32Array, visible: Uint8Array): void {
    const { count, rows, width } = this.#store
    if (count > 0) {
      const { index, share } = this.#store.locate(time)
      const next = Math.min(index + 1, count - 1)
      for (let k = 0; k < this.#places.length; k++) {
        const body = this.#places[k] ?? -1
        if (body < 0) continue
        const at = this.#columns + k * POSE
        between(poses, body, rows, index * width + at, next * width + at, share)
      }
    }
    this.#placements.write(time, poses, visible, count > 0 ? this.#tracked : NONE)
  }

  trail(kind: 'attained' | 'command', station: string): Trail {
    const channel = channelOf(`${kind}_position`, station)
    const known = this.#trails.get(channel)
    if (known) return known
    const position = [0, 1, 2].map(column => this.series(channel, column))
    const made = trailOf(this.#store.times(), position, this.#bases.get(station))
    this.#trails.set(channel, made)
    return made
  }

  #speedChannels(): readonly ChannelInfo[] {
    return this.stations.flatMap(({ name }) => {
      const position = this.#framed.find(one => one.name === channelOf('attained_position', name))
      if (position?.columns.length !== 3) return []
      const places = position.columns.map((_, column) => position.first + column)
      this.#positions.set(channelOf(TCP_SPEED, name), places)
      return [speedChannel(name, undefined)]
    })
  }

  #rows(place: number, from = 0, to = this.#store.count): Series {
    return { times: this.#store.times(from, to), values: this.#store.column(place, from, to), held: false }
  }

  /** The same as in the whole series, of the rows around a time only. */
  #speedAt(position: readonly number[], time: number): number {
    if (this.#store.count === 0) return Number.NaN
    const { index, share } = this.#store.locate(time)
    const [from, to] = [Math.max(index - AROUND, 0), Math.min(index + AROUND + 2, this.#store.count)]
    const speed = speedOf(position.map(place => this.#rows(place, from, to)))
    return speed ? valueIn(speed, index - from, share) : Number.NaN
  }

  /** Place of a column in a row, and whether it holds its value between changes. */
  #find(name: string, column: number): { readonly place: number; readonly held: boolean } | undefined {
    const channel = this.#framed.find(one => one.name === name)
    if (!channel || column < 0 || column >= channel.columns.length) return undefined
    return { place: channel.first + column, held: channel.held }
  }

  #widen(values: Float32Array): void {
    for (const { first, min, max } of this.#framed) {
      for (let k = 0; k < min.length; k++) {
        const value = values[first + k] ?? Number.NaN
        if (Number.isNaN(value)) continue
        // Comparing with the NaN that stands for "none yet" is false, too.
        if (!((min[k] ?? Number.NaN) <= value)) min[k] = value
        if (!((max[k] ?? Number.NaN) >= value)) max[k] = value
      }
    }
  }
}

const NONE = new Uint8Array(0)
/** So many rows on either side tell the speed at a time, however near they lie. */
const AROUND = 8

/** Neighbouring entries of one name are the columns of one channel. */
function channelsOf(layout: LiveLayout): LiveChannel[] {
  const channels: LiveChannel[] = []
  for (const [
    place,
    { name, column, unit, description, group, subject, held },
  ] of layout.channels.entries()) {
    let channel = channels.at(-1)
    if (channel?.name !== name) {
      channel = { name, unit, description, group, subject, columns: [], min: [], max: [], first: place, held }
      channels.push(channel)
    }
    channel.columns.push(column)
    channel.min.push(Number.NaN)
    channel.max.push(Number.NaN)
  }
  return channels
}
