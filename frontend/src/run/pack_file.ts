/** The file of a pack: gzip around a mark, a JSON header and the bytes of its columns (docs/reference/pack.md). */
import type { Pose } from '../scene/description'
import type { RunFacts } from '../wire/facts'
import type { ResultFigures } from '../wire/result'
import type { Contour, Finding, RunEvent } from './run'

export type ColumnCode =
  | { readonly kind: 'constant'; readonly value: number | null }
  | {
      readonly kind: 'steps'
      readonly times: readonly number[]
      readonly values: readonly (number | null)[]
    }
  | {
      readonly kind: 'smooth'
      readonly step: number
      readonly offset: number
      readonly length: number
      readonly gaps: readonly (readonly [number, number])[]
    }

export interface PackedColumn {
  readonly name: string
  readonly min: number | null
  readonly max: number | null
  readonly code: ColumnCode
}

export interface PackedChannel {
  readonly name: string
  readonly unit: string
  readonly description: string
  readonly group: string
  /** Name of the station or device that it is of; empty for what belongs to the cell. */
  readonly subject: string
  readonly columns: readonly PackedColumn[]
}

/** From `time` on a body rides on the body `parent` (-1: rests in W), in the frame of which `pose` counts. */
export interface Placement {
  readonly time: number
  readonly parent: number
  readonly pose: Pose
  readonly visible: boolean
}

export type PackedBody = { readonly name: string } & (
  | { readonly track: 'fixed' }
  | { readonly track: 'poses'; readonly columns: readonly ColumnCode[] }
  | { readonly track: 'placed'; readonly placements: readonly Placement[] }
)

export interface PackHeader {
  readonly version: number
  readonly duration: number
  readonly rate: number
  readonly count: number
  readonly project: string
  /** Poses of the base frames of the stations in W, by name. */
  readonly bases: Readonly<Record<string, Pose>>
  readonly channels: readonly PackedChannel[]
  readonly bodies: readonly PackedBody[]
  readonly events: readonly RunEvent[]
  readonly findings: readonly Finding[]
  /** Absent in packs of older versions. */
  readonly contours?: readonly Contour[]
  readonly result: ResultFigures
  readonly facts: RunFacts
}

/** A pack that cannot be read; the message is for the user. */
export class PackError extends Error {}

const MARK = 'RPK1'
const VERSION = 3
const HEAD = 8

/** Unpack the file. Throws `PackError` for anything that is not a whole pack of a known version. */
export async function openPack(file: ArrayBuffer): Promise<{ header: PackHeader; body: Uint8Array }> {
  const bytes = await gunzip(file)
  if (bytes.length < HEAD || new TextDecoder().decode(bytes.subarray(0, 4)) !== MARK) {
    throw new PackError('This is no recorded run: it does not begin with RPK1.')
  }
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true)
  if (HEAD + length > bytes.length) throw new PackError('The recorded run is cut off in its header.')
  const header = parse(bytes.subarray(HEAD, HEAD + length))
  if (header.version !== VERSION) {
    throw new PackError(`The recorded run has version ${header.version}; this page knows ${VERSION}.`)
  }
  return { header, body: bytes.subarray(HEAD + length) }
}

async function gunzip(file: ArrayBuffer): Promise<Uint8Array> {
  try {
    const stream = new Blob([file]).stream().pipeThrough(new DecompressionStream('gzip'))
    return new Uint8Array(await new Response(stream).arrayBuffer())
  } catch {
    throw new PackError('The recorded run is damaged: it cannot be unpacked.')
  }
}

function parse(bytes: Uint8Array): PackHeader {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes)) as PackHeader
  } catch {
    throw new PackError('The recorded run is damaged: its header cannot be read.')
  }
}
