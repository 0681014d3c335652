/** A finished run, read from its pack. */
import type { SceneDescription } from '../scene/description'
import type { Contact, RunFacts, WayFacts } from '../wire/facts'
import type { ResultFigures } from '../wire/result'
import { Clock, Column } from './column'
import { unitsByAxes } from './column_units'
import { openPack, type PackHeader } from './pack_file'
import { Placements } from './placements'
import { between, POSE } from './pose'
import type { ChannelInfo, Contour, Finding, Run, RunEvent, Series } from './run'
import { channelOf, type RunStation } from './station'
import { speedChannel, speedOf, TCP_SPEED, valueIn } from './tcp_speed'
import { type Trail, trailOf } from './trail'

export class RecordedRun implements Run {
  readonly live = false
  readonly stations: readonly RunStation[]
  readonly fidelity: 'dynamic' | 'kinematic'
  readonly project: string
  readonly duration: number
  readonly channels: readonly ChannelInfo[]
  readonly events: readonly RunEvent[]
  /** What the recording says about the run: stations with robot, limits and rates. */
  readonly facts: RunFacts
  readonly #header: PackHeader
  readonly #body: Uint8Array
  readonly #clock: Clock
  readonly #columns = new Map<string, readonly Column[]>()
  readonly #trails = new Map<string, Trail>()
  /** By the name of their channel. */
  readonly #speeds = new Map<string, Series>()
  #findings: readonly Finding[]
  #result: ResultFigures
  #ways: WayFacts | null
  #placements: Placements
  /** Seven values a sample for each body with poses, by place in the scene. */
  #poses: ReadonlyMap<number, Float64Array> = new Map()
  #tracked = new Uint8Array(0)

  private constructor(header: PackHeader, body: Uint8Array, scene: SceneDescription) {
    this.#header = header
    this.#body = body
    this.stations = header.facts.stations
    this.fidelity = header.facts.fidelity
    this.project = header.project
    this.duration = header.duration
    this.events = header.events
    this.#findings = header.findings
    this.#result = header.result
    this.#ways = header.facts.ways
    this.facts = header.facts
    this.#clock = new Clock(header.rate, header.duration, header.count)
    for (const channel of header.channels) {
      const columns = channel.columns.map(column => new Column(column.code, body, this.#clock))
      this.#columns.set(channel.name, columns)
    }
    const recorded = header.channels.map(({ name, unit, description, group, subject, columns }) => {
      const axes = this.facts.stations.find(one => one.name === subject)?.axes ?? []
      const names = columns.map(column => column.name)
      return {
        name,
        unit,
        units: unitsByAxes({ unit, columns: names }, axes),
        description,
        group,
        subject,
        columns: names,
        min: columns.map(column => column.min ?? Number.NaN),
        max: columns.map(column => column.max ?? Number.NaN),
      }
    })
    const speeds = this.stations.flatMap(({ name }) => {
      const position = channelOf('attained_position', name)
      const speed = speedOf([0, 1, 2].map(column => this.#recorded(position, column)))
      if (!speed) return []
      this.#speeds.set(channelOf(TCP_SPEED, name), speed)
      return [speedChannel(name, speed)]
    })
    this.channels = [...recorded, ...speeds]
    this.#placements = placementsIn(scene, header)
    this.showIn(scene)
  }

  /** Read a pack for a scene. Throws `PackError` with words for the user. */
  static async decode(file: ArrayBuffer, scene: SceneDescription): Promise<RecordedRun> {
    const { header, body } = await openPack(file)
    return new RecordedRun(header, body, scene)
  }

  /** Take findings, figures and contacts that are known since the collisions of the run were checked. */
  tell(findings: readonly Finding[], result: ResultFigures, ways: WayFacts | null): void {
    this.#findings = findings
    this.#result = result
    this.#ways = ways
  }

  get contacts(): readonly Contact[] | undefined {
    return this.#ways?.contacts
  }

  get findings(): readonly Finding[] {
    return this.#findings
  }

  get contours(): readonly Contour[] {
    return this.#header.contours ?? []
  }

  get result(): ResultFigures {
    return this.#result
  }

  /** Let the bodies of another description of the cell be moved; those that the run does not know stand still. */
  showIn(scene: SceneDescription): void {
    const poses = new Map<number, Float64Array>()
    this.#placements = placementsIn(scene, this.#header)
    this.#tracked = new Uint8Array(scene.bodies.length)
    for (const [index, body] of this.#header.bodies.entries()) {
      const place = this.#placements.placeOf(index)
      if (place < 0) continue
      if (body.track === 'poses') {
        poses.set(place, this.#posesOf(body.columns.map(code => new Column(code, this.#body, this.#clock))))
        this.#tracked[place] = 1
      } else if (body.track === 'placed') {
        for (const one of body.placements) this.#placements.add(index, one)
      }
    }
    this.#poses = poses
  }

  value(channel: string, column: number, time: number): number {
    const speed = this.#speeds.get(channel)
    if (speed) {
      const { index, share } = this.#clock.locate(time)
      return valueIn(speed, index, share)
    }
    return this.#columns.get(channel)?.[column]?.value(time) ?? Number.NaN
  }

  series(channel: string, column: number): Series | undefined {
    return this.#speeds.get(channel) ?? this.#recorded(channel, column)
  }

  #recorded(channel: string, column: number): Series | undefined {
    return this.#columns.get(channel)?.[column]?.series
  }

  bodies(time: number, poses: Float32Array, visible: Uint8Array): void {
    const { index, share } = this.#clock.locate(time)
    const first = index * POSE
    const second = Math.min(index + 1, this.#clock.count - 1) * POSE
    for (const [body, samples] of this.#poses) between(poses, body, samples, first, second, share)
    this.#placements.write(time, poses, visible, this.#tracked)
  }

  trail(kind: 'attained' | 'command', station: string): Trail {
    const channel = channelOf(`${kind}_position`, station)
    const known = this.#trails.get(channel)
    if (known) return known
    const position = [0, 1, 2].map(column => this.series(channel, column))
    const made = trailOf(this.#clock.times, position, this.#header.bases[station])
    this.#trails.set(channel, made)
    return made
  }

  #posesOf(columns: readonly Column[]): Float64Array {
    const samples = new Float64Array(POSE * this.#clock.count)
    for (const [k, column] of columns.entries()) {
      const { values, held } = column.series
      for (let n = 0; n < this.#clock.count; n++) samples[POSE * n + k] = values[held ? 0 : n] ?? 0
    }
    return samples
  }
}

function placementsIn(scene: SceneDescription, header: PackHeader): Placements {
  return new Placements(
    scene,
    header.bodies.map(body => body.name),
  )
}
