import { describe, expect, it } from 'vitest'
import { decodeFrame } from './frame'

function frame(values: readonly number[], poses: readonly number[], bodies = poses.length / 7): ArrayBuffer {
  const bytes = new ArrayBuffer(32 + 4 * (values.length + poses.length))
  const view = new DataView(bytes)
  view.setUint8(0, 0x52)
  view.setUint8(1, 0x53)
  view.setUint8(2, 1)
  view.setUint8(3, 1)
  view.setUint32(4, 9, true)
  view.setFloat64(8, 1.25, true)
  view.setFloat64(16, 1.7e12, true)
  view.setUint16(24, values.length, true)
  view.setUint16(26, bodies, true)
  for (const [k, value] of [...values, ...poses].entries()) view.setFloat32(32 + 4 * k, value, true)
  return bytes
}

describe('a state frame', () => {
  const bytes = frame([0.5, 2], [1, 2, 3, 1, 0, 0, 0])

  it('is read back', () => {
    const read = decodeFrame(bytes)
    expect(read?.sequence).toBe(9)
    expect(read?.time).toBe(1.25)
    expect(read?.wall).toBe(1.7e12)
    expect([...(read?.values ?? [])]).toEqual([0.5, 2])
    expect([...(read?.poses ?? [])]).toEqual([1, 2, 3, 1, 0, 0, 0])
  })

  it('of another length, kind, version or without a time is no frame', () => {
    expect(decodeFrame(new ArrayBuffer(0))).toBeUndefined()
    expect(decodeFrame(bytes.slice(0, 40))).toBeUndefined()
    expect(decodeFrame(frame([1], [], 3))).toBeUndefined()
    for (const place of [0, 1, 2, 3]) {
      const other = bytes.slice(0)
      new DataView(other).setUint8(place, 7)
      expect(decodeFrame(other)).toBeUndefined()
    }
    const timeless = bytes.slice(0)
    new DataView(timeless).setFloat64(8, Number.NaN, true)
    expect(decodeFrame(timeless)).toBeUndefined()
  })
})
