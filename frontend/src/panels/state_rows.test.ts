import { expect, test } from 'vitest'
import { unitsByAxes } from '../run/column_units'
import type { ChannelInfo } from '../run/run'
import type { JointDescription, StationDescription } from '../scene/description'
import { filterRows, share, stateRows } from './state_rows'

const JOINTS: readonly JointDescription[] = [
  { name: '1', type: 'revolute', lower: -1, upper: 2, maxSpeed: 3 },
  { name: '2', type: 'prismatic', lower: 0, upper: 0.5, maxSpeed: 0.2 },
]

const STATION: StationDescription = {
  name: 'robot',
  robot: 'r',
  title: 'R',
  program: 'main',
  tool: '',
  base: [0, 0, 0, 1, 0, 0, 0],
  joints: JOINTS,
}

function channel(
  name: string,
  unit: string,
  columns: readonly string[],
  group: string,
  subject = 'robot',
): ChannelInfo {
  const numbers = columns.map(() => 0)
  return {
    name,
    unit,
    units: unitsByAxes({ unit, columns }, STATION.joints),
    columns,
    description: `all about ${name}`,
    group,
    subject,
    min: numbers,
    max: numbers.map(() => 7),
  }
}

const ROWS = stateRows(
  [
    channel('q', 'rad | m', ['1', '2'], 'joints'),
    channel('qd', 'rad | m/s', ['1', '2'], 'joints'),
    channel('payload', 'kg', [''], 'program'),
  ],
  [STATION],
)

test('joint coordinates range between their limits, speeds up to the greatest, others as recorded', () => {
  expect(ROWS.map(row => [row.name, row.min, row.max])).toEqual([
    ['Joint 1 position', -1, 2],
    ['Joint 2 position', 0, 0.5],
    ['Joint 1 speed', -3, 3],
    ['Joint 2 speed', -0.2, 0.2],
    ['Payload', 0, 7],
  ])
})

test('only joint coordinates can be jogged', () => {
  expect(ROWS.map(row => row.joint)).toEqual([0, 1, -1, -1, -1])
})

test('a prismatic joint is measured in metres', () => {
  expect(ROWS.map(row => row.unit)).toEqual(['rad', 'm', 'rad/s', 'm/s', 'kg'])
})

test('rows are found by group and by words of name, symbol and description', () => {
  expect(filterRows(ROWS, 'program', '').map(row => row.name)).toEqual(['Payload'])
  expect(filterRows(ROWS, '', 'about Q 2').map(row => row.name)).toEqual([
    'Joint 2 position',
    'Joint 2 speed',
  ])
  expect(filterRows(ROWS, 'joints', 'payload')).toEqual([])
})

test('a share is between 0 and 1 whatever the range', () => {
  expect(share(1, 0, 4)).toBe(0.25)
  expect([share(9, 0, 4), share(-9, 0, 4), share(1, 3, 3), share(Number.NaN, 0, 1)]).toEqual([1, 0, 0, 0])
})

test('each station has its own joints, and its name stands before what is its', () => {
  const stations = [
    { ...STATION, name: 'left' },
    { ...STATION, name: 'right', joints: JOINTS.slice(0, 1) },
  ]
  const rows = stateRows(
    [
      channel('left/q', 'rad', ['1', '2'], 'joints', 'left'),
      channel('right/q', 'rad', ['1'], 'joints', 'right'),
      channel('infeed/q', 'm', ['1'], 'devices', 'infeed'),
    ],
    stations,
  )
  expect(rows.map(row => [row.name, row.subject, row.joint, row.max])).toEqual([
    ['left: Joint 1 position', 'left', 0, 2],
    ['left: Joint 2 position', 'left', 1, 0.5],
    ['right: Joint 1 position', 'right', 0, 2],
    ['infeed: Joint 1 position', 'infeed', -1, 7],
  ])
})
