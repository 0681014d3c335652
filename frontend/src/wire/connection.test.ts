import { expect, test } from 'vitest'
import { BACK_OFF, Connection, type ConnectionState, type Surroundings } from './connection'
import { REFUSED } from './entry'

class FakeSocket {
  readyState = 0
  binaryType = ''
  readonly sent: string[] = []
  onopen: (() => void) | null = null
  onmessage: ((event: { data: unknown }) => void) | null = null
  onclose: ((event: { code: number }) => void) | null = null

  send(text: string): void {
    this.sent.push(text)
  }

  close(): void {
    this.drop()
  }

  welcome(): void {
    this.readyState = 1
    this.say({ type: 'challenge', nonce: 'n' })
    this.say({ type: 'entered', ticket: 't', key: 'k' })
    this.onmessage?.({ data: JSON.stringify({ type: 'welcome' }) })
  }

  say(message: object): void {
    this.onmessage?.({ data: JSON.stringify(message) })
  }

  drop(code = 1006): void {
    this.readyState = 3
    this.onclose?.({ code })
  }
}

function bench() {
  const sockets: FakeSocket[] = []
  const waits: { milliseconds: number; act: () => void }[] = []
  const states: ConnectionState[] = []
  const messages: string[] = []
  const around: Surroundings = {
    open: () => {
      const socket = new FakeSocket()
      sockets.push(socket)
      return socket as unknown as WebSocket
    },
    door: { answer: async nonce => `answer to ${nonce}`, entered: () => {} },
    after: (milliseconds, act) => {
      waits.push({ milliseconds, act })
      return () => {}
    },
  }
  const frames: number[] = []
  const connection = new Connection(
    'ws://x',
    'tab-1',
    {
      onMessage: message => messages.push(message.type),
      onFrame: bytes => frames.push(bytes.byteLength),
      onState: state => states.push(state),
    },
    around,
  )
  return { connection, sockets, waits, states, messages, frames }
}

test('says hello with the name of the tab and is connected once it is welcome', () => {
  const { connection, sockets, states, messages } = bench()
  connection.open()
  sockets[0]?.welcome()
  expect(JSON.parse(sockets[0]?.sent[0] ?? '')).toEqual({ type: 'hello', tab: 'tab-1' })
  expect(states).toEqual(['connected'])
  expect(messages).toEqual(['welcome'])
})

test('sends nothing before the welcome and says so', () => {
  const { connection, sockets } = bench()
  connection.open()
  expect(connection.send({ type: 'cancel' })).toBe(false)
  sockets[0]?.welcome()
  expect(connection.send({ type: 'cancel' })).toBe(true)
  expect(sockets[0]?.sent).toHaveLength(2)
})

test('answers the challenge before anything else, and never says the key', async () => {
  const { connection, sockets, messages } = bench()
  connection.open()
  const [socket] = sockets
  if (!socket) return
  socket.readyState = 1
  socket.say({ type: 'challenge', nonce: 'n' })
  await Promise.resolve()
  expect(socket.sent).toEqual([JSON.stringify({ type: 'enter', answer: 'answer to n' })])
  expect(messages).toEqual([])
})

test('comes back by itself, waiting longer each time, and begins anew after a success', () => {
  const { connection, sockets, waits, states } = bench()
  connection.open()
  sockets[0]?.welcome()
  sockets[0]?.drop()
  waits[0]?.act()
  sockets[1]?.drop()
  waits[1]?.act()
  sockets[2]?.welcome()
  sockets[2]?.drop()
  expect(waits.map(one => one.milliseconds)).toEqual([BACK_OFF[0], BACK_OFF[1], BACK_OFF[0]])
  expect(states).toEqual(['connected', 'lost', 'connected', 'lost'])
})

test('a key that the server refuses is expired; it is asked again seldom, for its own studio may come back', () => {
  const { connection, sockets, waits, states } = bench()
  connection.open()
  sockets[0]?.drop(REFUSED)
  expect(states).toEqual(['expired'])
  expect(waits.map(one => one.milliseconds)).toEqual([BACK_OFF.at(-1)])
  waits[0]?.act()
  sockets[1]?.welcome()
  expect(states).toEqual(['expired', 'connected'])
})

test('binary messages are frames', () => {
  const { connection, sockets, frames } = bench()
  connection.open()
  sockets[0]?.welcome()
  sockets[0]?.onmessage?.({ data: new ArrayBuffer(40) })
  expect(frames).toEqual([40])
})

test('a closed connection stays closed', async () => {
  const { connection, sockets, waits } = bench()
  connection.open()
  sockets[0]?.welcome()
  connection.close()
  await Promise.resolve()
  expect(waits).toHaveLength(0)
})
