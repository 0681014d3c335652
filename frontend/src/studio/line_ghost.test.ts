import { expect, test } from 'vitest'
import { Cursor } from '../run/cursor'
import { LiveRun } from '../run/live_run'
import type { SceneDescription } from '../scene/description'
import type { LiveLayout } from '../wire/messages'
import { LineGhost } from './line_ghost'
import { Picture } from './picture'
import { RunLines } from './run_lines'
import { createStudioStore } from './state'

const DOCUMENT = 'programs/main.task'
const LINE = { name: 'line', column: '', unit: '', description: '', group: '', subject: '', held: true }
const LAYOUT: LiveLayout = {
  type: 'layout',
  channels: [LINE],
  bodies: [],
  stations: [{ name: 'robot', program: 'main', source: 'main.task' }],
}
const SCENE = { bodies: [], stations: [] } as unknown as SceneDescription

function ghostOf(run: LiveRun): LineGhost {
  const lines = new RunLines({ text: () => 'mov a\nmov b', documentOf: () => DOCUMENT })
  const cursor = new Cursor()
  return new LineGhost(createStudioStore(), new Picture(cursor), {
    run: () => run,
    time: () => 0,
    documentOf: () => DOCUMENT,
    lines,
    mark: () => {},
  })
}

function begun(): LiveRun {
  return new LiveRun(SCENE, LAYOUT)
}

test('a live run that has no frame yet runs no line', () => {
  expect(ghostOf(begun()).running()).toEqual([])
})

test('the line of the last frame runs', () => {
  const run = begun()
  run.add({ sequence: 0, time: 0, wall: 0, values: Float32Array.of(2), poses: new Float32Array(0) })
  expect(ghostOf(run).running()).toEqual([{ document: DOCUMENT, line: 2 }])
})

test('each station runs a line of its own', () => {
  const stations = ['left', 'right'].map(name => ({ name, program: name, source: name }))
  const channels = ['left/line', 'right/line'].map(name => ({ ...LINE, name }))
  const run = new LiveRun(SCENE, { ...LAYOUT, channels, stations })
  run.add({ sequence: 0, time: 0, wall: 0, values: Float32Array.of(1, 2), poses: new Float32Array(0) })
  expect(ghostOf(run).running()).toEqual([
    { document: DOCUMENT, line: 1 },
    { document: DOCUMENT, line: 2 },
  ])
})
