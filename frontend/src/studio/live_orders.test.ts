import { beforeEach, expect, test } from 'vitest'
import { Cursor } from '../run/cursor'
import { Transport } from '../run/transport'
import type { Command } from '../wire/commands'
import type { LiveStatus } from '../wire/messages'
import { driveLiveRuns, type LiveOrders } from './live_orders'
import { createStudioStore, type StudioStore } from './state'

let sent: Command[]
let store: StudioStore
let transport: Transport
let orders: LiveOrders
beforeEach(() => {
  sent = []
  store = createStudioStore()
  transport = new Transport(new Cursor())
  transport.cursor.setEnd(5)
  orders = driveLiveRuns(store, transport, command => sent.push(command) > 0)
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

const actions = () => sent.map(one => 'action' in one && one.action)

test('a second press that is quicker than the answer takes the first one back', () => {
  live('running')
  for (const _ of Array(4)) transport.toggle()
  expect(actions()).toEqual(['hold', 'continue', 'hold', 'continue'])
  for (const state of ['held', 'running', 'held'] as const) {
    live(state) // an answer to an earlier order does not say how the run will stand
    expect(orders.state).toBe('running')
  }
  live('running')
  transport.toggle()
  expect(actions().at(-1)).toBe('hold')
})

test('buttons, menu and the key count from the same state', () => {
  live('running')
  expect(orders.order('hold')).toBe(true)
  expect(orders.order('hold')).toBe(false)
  transport.toggle()
  expect(orders.order('step')).toBe(false)
  expect(actions()).toEqual(['hold', 'continue'])
})

test('a step ends held without an order, and the next press goes on from there', () => {
  live('held')
  orders.order('step')
  expect(orders.order('step')).toBe(false)
  live('running')
  live('held')
  transport.toggle()
  expect(actions()).toEqual(['step', 'continue'])
})

test('what the run says of its override in between answers no order', () => {
  live('running')
  transport.toggle()
  live('running')
  transport.toggle()
  expect(actions()).toEqual(['hold', 'continue'])
})

test('orders to a run that is over are forgotten', () => {
  live('running')
  transport.toggle()
  live('over')
  expect(orders.order('continue')).toBe(false)
  live('starting')
  live('running')
  transport.toggle()
  expect(actions()).toEqual(['hold', 'hold'])
})

test('orders that a lost connection has swallowed count no more', () => {
  store.setState({ connection: 'connected' })
  live('running')
  orders.order('hold')
  expect(orders.state).toBe('held')
  store.setState({ connection: 'lost' })
  expect(orders.state).toBe('running')
  expect(orders.order('hold')).toBe(true)
})
