import { beforeEach, expect, test } from 'vitest'
import { Cursor } from '../run/cursor'
import { Transport } from '../run/transport'
import type { Command } from '../wire/commands'
import type { LiveStatus } from '../wire/messages'
import { driveLiveRuns } from './live_player'
import { createStudioStore, type StudioStore } from './state'

let sent: Command[]
let store: StudioStore
let transport: Transport
beforeEach(() => {
  sent = []
  store = createStudioStore()
  transport = new Transport(new Cursor())
  transport.cursor.setEnd(5)
  driveLiveRuns(store, transport, command => sent.push(command) > 0)
})

function live(state: LiveStatus['state']): void {
  store.setState({ live: { type: 'live', state, speed: 1, program: 'main', override: 1 } })
}

test('pausing in a live run holds the run, not the cursor', () => {
  live('running')
  expect(transport.playing).toBe(true)
  transport.toggle()
  live('held')
  transport.toggle()
  expect(sent.map(one => 'action' in one && one.action)).toEqual(['hold', 'continue'])
  expect(transport.cursor.playing).toBe(false)
})

test('a live run that is being prepared is left alone', () => {
  live('starting')
  transport.toggle()
  expect(sent).toEqual([])
})

test('after the live run the cursor plays again', () => {
  live('running')
  live('over')
  transport.toggle()
  expect(sent).toEqual([])
  expect(transport.cursor.playing).toBe(true)
})
