import { expect, test } from 'vitest'
import { csvOf } from './csv'
import type { Run, Series } from './run'

const times = Float64Array.of(0, 0.5, 1)
const held: Series = { times: Float64Array.of(0), values: Float64Array.of(1), held: true }
const values: Readonly<Record<string, readonly number[]>> = {
  q: [0, Math.PI / 2, Math.PI],
  path_error: [Number.NaN, 0.00012, 0],
  'signal.a, "b"': [1, 1, 1],
}
const run = {
  channels: [
    { name: 'q', unit: 'rad', columns: ['1'] },
    { name: 'path_error', unit: 'm', columns: [''] },
    { name: 'signal.a, "b"', unit: '', columns: [''] },
  ],
  series: (name: string) => (name.startsWith('signal') ? held : { times, values: times, held: false }),
  value: (name: string, _: number, time: number) => values[name]?.[2 * time],
} as unknown as Run

test('columns are named and in shown units, gaps are empty', () => {
  expect(csvOf(run).split('\r\n')).toEqual([
    'Time [s],Joint 1 position [°],Path error [mm],"a, ""b"""',
    '0,0,,1',
    '0.5,90,0.12,1',
    '1,180,0,1',
    '',
  ])
})
