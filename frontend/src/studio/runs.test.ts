import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import fixture from '../run/fixtures/first_cell.json'
import type { Run } from '../run/run'
import type { SceneDescription } from '../scene/description'
import { Runs } from './runs'

const scene = fixture.scene as unknown as SceneDescription
const pack = Uint8Array.from(atob(fixture.pack), c => c.charCodeAt(0)).buffer

/** A cell of one body: poses of more would be written beyond the end. */
const onlyBase: SceneDescription = { ...scene, bodies: scene.bodies.slice(0, 1) }

/** Answers that the server has not given yet, by address. */
const asked = new Map<string, (answer: Response) => void>()
let shown: Run[]
let told: Run[]
let troubles: string[]
let runs: Runs

beforeEach(() => {
  asked.clear()
  shown = []
  told = []
  troubles = []
  runs = new Runs({
    onRun: run => shown.push(run),
    onTold: run => told.push(run),
    onGrown: () => {},
    onTrouble: text => troubles.push(text),
  })
  vi.stubGlobal('fetch', (address: string) => new Promise<Response>(answer => asked.set(address, answer)))
})
afterEach(() => {
  vi.unstubAllGlobals()
})

const give = (id: number, body: BodyInit = pack) => asked.get(`/run/${id}.pack`)?.(new Response(body))

test('of two runs the newer one stays, whichever comes first', async () => {
  runs.setScene(scene)
  const [first, second] = [runs.take(1), runs.take(2)]
  give(2)
  await second
  give(1)
  await first
  expect(shown).toHaveLength(1)
  expect(runs.run).toBe(shown[0])
})

test('what is told of a run whose ways were looked at takes the place of what its pack says', async () => {
  runs.setScene(scene)
  const first = runs.take(1)
  give(1)
  await first
  const run = runs.run
  const result = run?.result
  if (!result) throw new Error('a run of a program has a result')
  const ways = {
    type: 'ways',
    findings: [],
    result: { ...result, unchecked: 'nothing' },
    ways: null,
  } as const
  runs.see({ ...ways, run: 2 })
  expect(told).toHaveLength(0)
  expect(run.result).toBe(result)
  runs.see({ ...ways, run: 1 })
  expect(told).toEqual([run])
  expect(runs.run).toBe(run)
  expect(run.result?.unchecked).toBe('nothing')
  expect(run.findings).toEqual([])
  // A page that comes later hears of them before it has the pack.
  const again = runs.take(1)
  give(1)
  await again
  expect(runs.run?.result?.unchecked).toBe('nothing')
  expect(told).toHaveLength(1)
})

test('a pack that comes before the scene waits for it', async () => {
  const taken = runs.take(1)
  give(1)
  await taken
  expect(shown).toHaveLength(0)
  runs.setScene(scene)
  await vi.waitFor(() => expect(shown).toHaveLength(1))
  expect(runs.run?.duration).toBeGreaterThan(0)
})

test('a damaged pack is told, also when it came before the scene', async () => {
  const taken = runs.take(1)
  give(1, 'no pack')
  await taken
  runs.setScene(scene)
  await vi.waitFor(() => expect(troubles).toHaveLength(1))
  expect(troubles[0]).toMatch(/damaged/)
})

test('a scene that comes while a pack is unpacked is the one that counts', async () => {
  runs.setScene(scene)
  const Real = DecompressionStream
  vi.stubGlobal(
    'DecompressionStream',
    class extends Real {
      constructor(format: CompressionFormat) {
        super(format)
        runs.setScene(onlyBase)
      }
    },
  )
  const taken = runs.take(1)
  give(1)
  await taken
  const poses = new Float32Array(7)
  expect(() => runs.run?.bodies(0, poses, new Uint8Array(1))).not.toThrow()
  expect([...poses]).toEqual([...Float32Array.from(scene.bodies[0]?.pose ?? [])])
})

test('bodies of a live run follow a cell that is edited meanwhile', () => {
  runs.setScene(scene)
  runs.startLive({ type: 'layout', channels: [], bodies: [], stations: [] })
  runs.setScene(onlyBase)
  expect(() => runs.run?.bodies(0, new Float32Array(7), new Uint8Array(1))).not.toThrow()
})

test('a run that the server has forgotten is told', async () => {
  runs.setScene(scene)
  const taken = runs.take(7)
  asked.get('/run/7.pack')?.(new Response('', { status: 404 }))
  await taken
  expect(troubles).toHaveLength(1)
})
