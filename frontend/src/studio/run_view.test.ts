import { expect, test } from 'vitest'
import { Cursor } from '../run/cursor'
import fixture from '../run/fixtures/first_cell.json'
import { RecordedRun } from '../run/recorded_run'
import { Transport } from '../run/transport'
import type { SceneDescription } from '../scene/description'
import type { RunStatus } from '../wire/messages'
import { Loop } from './loop'
import { Picture } from './picture'
import { RunView } from './run_view'
import { createStudioStore } from './state'

const scene = fixture.scene as unknown as SceneDescription
const pack = Uint8Array.from(atob(fixture.pack), c => c.charCodeAt(0)).buffer
const status = (state: RunStatus['state']) => ({ type: 'run', id: 2, state, program: 'main' }) as RunStatus

async function shownWhile(state: RunStatus['state']): Promise<boolean> {
  const store = createStudioStore()
  const transport = new Transport(new Cursor())
  const idle = { frame: () => {}, calmFrame: () => {}, after: () => () => {} }
  const loop = new Loop(
    () => false,
    () => {},
    idle,
  )
  const view = new RunView(store, transport, new Picture(transport.cursor), loop)
  store.setState({ status: status(state) })
  view.show(await RecordedRun.decode(pack, scene))
  return store.getState().stale
}

test('the last good run is old for a page that was opened while the text has errors', async () => {
  expect(await shownWhile('refused')).toBe(true)
  expect(await shownWhile('failed')).toBe(true)
})

test('a run that has just been done is not old', async () => {
  expect(await shownWhile('done')).toBe(false)
})
