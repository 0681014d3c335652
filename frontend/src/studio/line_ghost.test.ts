import { expect, test } from 'vitest'
import { Cursor } from '../run/cursor'
import { LiveRun } from '../run/live_run'
import type { Run } from '../run/run'
import type { SceneDescription } from '../scene/description'
import type { LiveLayout } from '../wire/messages'
import { LineGhost, type LineWires } from './line_ghost'
import { Picture } from './picture'
import { RunLines } from './run_lines'
import { createStudioStore, type StudioStore } from './state'

const DOCUMENT = 'programs/main.task'
const LINE = { name: 'line', column: '', unit: '', description: '', group: '', subject: '', held: true }
const LAYOUT: LiveLayout = {
  type: 'layout',
  channels: [LINE],
  bodies: [],
  stations: [{ name: 'robot', program: 'main', source: 'main.task' }],
}
const SCENE = { bodies: [], stations: [] } as unknown as SceneDescription

const TEXT = 'mov a\nmov b'

function ghostOf(run: LiveRun): LineGhost {
  return ghostIn(createStudioStore(), { run: () => run, text: () => TEXT })
}

function ghostIn(store: StudioStore, { run, text }: Pick<LineWires, 'run' | 'text'>): LineGhost {
  return new LineGhost(store, new Picture(new Cursor()), {
    run,
    time: () => 0,
    documentOf: () => DOCUMENT,
    text,
    lines: new RunLines({ text, documentOf: () => DOCUMENT }),
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

/** A run of one move on line 2. */
function moved(): LiveRun {
  const run = begun()
  const span = { source: 'main.task', line: 2, column: 1, end_line: 2, end_column: 6 }
  run.events.push({ kind: 'move', time: 1, duration: 2, text: '', station: 'robot', span, data: {} })
  return run
}

test('a line that was asked for before its run shows its ghost when the run comes', () => {
  const store = createStudioStore()
  let run: Run | null = null
  const ghost = ghostIn(store, { run: () => run, text: () => TEXT })
  ghost.show(DOCUMENT, 2)
  expect(store.getState().ghost).toBeNull()
  run = moved()
  ghost.renew()
  expect(store.getState().ghost).toMatchObject({ line: 2, time: 3 })
})

test('a moment of a line shows the pass of that moment, at the moment itself', () => {
  const run = moved()
  run.events.push({ ...(run.events[0] as Run['events'][number]), time: 11 })
  const store = createStudioStore()
  const ghost = ghostIn(store, { run: () => run, text: () => TEXT })
  ghost.showAt(DOCUMENT, 2, 12.5)
  expect(store.getState().ghost).toMatchObject({ line: 2, pass: 2, passes: 2, time: 12.5 })
  ghost.showAt(DOCUMENT, 1, 12.5)
  expect(store.getState().ghost).toBeNull()
})

test('a line that was asked for in another text is not that line any more', () => {
  const store = createStudioStore()
  let run: Run | null = null
  let text = TEXT
  const ghost = ghostIn(store, { run: () => run, text: () => text })
  ghost.show(DOCUMENT, 2)
  text = `delay 1 s\n${TEXT}`
  run = moved()
  ghost.renew()
  expect(store.getState().ghost).toBeNull()
})
