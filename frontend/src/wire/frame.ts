/** State frames of a live run: the only binary messages on `/ws/studio`. */

export interface StateFrame {
  readonly sequence: number
  /** Simulated time [s]. */
  readonly time: number
  /** Wall clock of the server [ms since 1970]. */
  readonly wall: number
  /** Values in the order of the layout. */
  readonly values: Float32Array
  /** World poses in the order of `layout.bodies`, seven numbers each. */
  readonly poses: Float32Array
}

const HEAD = 32
const VERSION = 1
const STATE = 1

/** Read a frame; undefined for bytes that are none, so that a strange message never stops the page. */
export function decodeFrame(bytes: ArrayBuffer): StateFrame | undefined {
  if (bytes.byteLength < HEAD) return undefined
  const view = new DataView(bytes)
  const [r, s] = [view.getUint8(0), view.getUint8(1)]
  if (r !== 0x52 || s !== 0x53 || view.getUint8(2) !== VERSION || view.getUint8(3) !== STATE) return undefined
  const values = view.getUint16(24, true)
  const bodies = view.getUint16(26, true)
  const time = view.getFloat64(8, true)
  if (bytes.byteLength !== HEAD + 4 * (values + 7 * bodies) || !Number.isFinite(time)) return undefined
  return {
    sequence: view.getUint32(4, true),
    time,
    wall: view.getFloat64(16, true),
    values: new Float32Array(bytes, HEAD, values),
    poses: new Float32Array(bytes, HEAD + 4 * values, 7 * bodies),
  }
}
