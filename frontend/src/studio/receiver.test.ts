import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import fixture from '../run/fixtures/first_cell.json'
import type { SceneDescription } from '../scene/description'
import type { DocumentState, Message, Notice, RunStatus, Welcome } from '../wire/messages'
import { Receiver } from './receiver'
import { Studio } from './studio'

const scene = fixture.scene as unknown as SceneDescription
const document = (name: string, recovered = false): DocumentState => ({
  name,
  uri: `file:///cell/${name}`,
  language: 'task',
  text: '',
  version: 0,
  unsaved: recovered,
  base: '',
  conflict: false,
  recovered,
})
const WELCOME: Welcome = {
  type: 'welcome',
  ropsim: '0',
  project: 'cell',
  folder: '/cell',
  programs: ['pick', 'place'],
  program: 'place',
  documents: [document('cell.toml'), document('programs/pick.task'), document('programs/place.task')],
  editing: true,
  trust: { trusted: false, code: [] },
  recent: [],
  examples: [],
}
const sceneMessage = (shown: SceneDescription | null): Message => ({
  type: 'scene',
  scene: shown,
  findings: [],
})

let studio: Studio
let receiver: Receiver
const state = () => studio.store.getState()

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 1)
  // A browser that cannot draw.
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => null }) })
  // Not started: no connection is made.
  studio = new Studio('ws://127.0.0.1:9/ws/studio')
  receiver = new Receiver(studio)
})

afterEach(() => {
  vi.unstubAllGlobals()
})

describe('the answer to a dialog', () => {
  const refusal: Notice = { type: 'notice', level: 'error', code: 'U957', text: 'taken', hint: 'another' }

  it('closes it where all is done', () => {
    studio.store.setState({ dialog: 'newProgram', refusal })
    receiver.receive({ type: 'answered', refusal: null })
    expect([state().dialog, state().refusal]).toEqual([null, null])
  })

  it('keeps it open with the reason', () => {
    studio.store.setState({ dialog: 'newProgram' })
    receiver.receive({ type: 'answered', refusal })
    expect([state().dialog, state().refusal, state().notices]).toEqual(['newProgram', refusal, []])
  })

  it('is a notice where the dialog is closed by now', () => {
    receiver.receive({ type: 'answered', refusal })
    expect(state().notices.map(one => one.text)).toEqual(['taken'])
  })
})

describe('a welcome', () => {
  it('shows the program that runs when none is named', () => {
    receiver.receive(WELCOME)
    expect(state().document).toBe('programs/place.task')
  })

  it('leaves the shown document after the connection was lost', () => {
    receiver.receive(WELCOME)
    studio.store.setState({ document: 'cell.toml' })
    receiver.receive(WELCOME)
    expect(state().document).toBe('cell.toml')
  })

  it('forgets a live run that may be over', () => {
    receiver.receive({ type: 'live', state: 'running', speed: 1, program: 'place', override: 1 })
    studio.store.setState({ following: true })
    receiver.receive(WELCOME)
    expect([state().live, state().following]).toEqual([null, false])
  })

  it('tells of texts that were brought back', () => {
    receiver.receive({ ...WELCOME, documents: [document('programs/place.task', true)] })
    expect(state().notices.map(one => one.level)).toEqual(['warning'])
  })

  it('names all texts that are not saved, also those in which somebody has typed since they were brought back', () => {
    const typed = { ...document('cell.toml'), unsaved: true }
    const documents = [typed, document('programs/pick.task'), document('programs/place.task', true)]
    receiver.receive({ ...WELCOME, documents })
    const text = '2 unsaved texts have been brought back: cell.toml, programs/place.task.'
    expect(state().notices.map(one => one.text)).toEqual([text])
  })

  it('tells of texts that were brought back once', () => {
    const documents = [document('programs/place.task', true)]
    receiver.receive({ ...WELCOME, documents })
    studio.dismiss(state().notices[0]?.id ?? 0)
    receiver.receive({ ...WELCOME, documents: [...documents, document('programs/new.task')] })
    expect(state().notices).toEqual([])
  })
})

describe('texts that the server sends', () => {
  it('renew what may be chosen where they are of tasks and new to the page', () => {
    receiver.receive(WELCOME)
    const renewed = vi.spyOn(studio, 'renewTasks').mockReturnValue()
    const told = (name: string, text: string | null) =>
      receiver.receive({ type: 'documents', documents: [{ ...document(name), text }] })
    told('programs/place.task', 'program place')
    told('kb/own.pl', null)
    expect(renewed).toHaveBeenCalledTimes(0)
    told('kb/own.pl', 'goal(done/0).')
    expect(renewed).toHaveBeenCalledTimes(1)
  })
})

describe('a scene', () => {
  it('keeps the selected body, wherever it stands now', () => {
    receiver.receive(sceneMessage(scene))
    const last = scene.bodies.length - 1
    studio.select(last)
    const first = scene.bodies[0]
    if (!first) throw new Error('the example has bodies')
    receiver.receive(sceneMessage({ ...scene, bodies: [{ ...first, name: 'new' }, ...scene.bodies] }))
    expect(state().selected).toBe(last + 1)
    receiver.receive(sceneMessage({ ...scene, bodies: scene.bodies.slice(0, last) }))
    expect(state().selected).toBeNull()
  })

  it('that is broken leaves the last good one', () => {
    receiver.receive(sceneMessage(scene))
    receiver.receive(sceneMessage(null))
    expect(state().scene).toBe(scene)
    expect(state().cellBroken).toBe(true)
  })
})

describe('a run', () => {
  const status: RunStatus = {
    type: 'run',
    id: 1,
    state: 'failed',
    program: 'place',
    message: 'out of memory',
    findings: [],
    inputs: 0,
    planned: false,
    simulated: 0,
    versions: {},
    age: 'newest',
    results: {},
  }

  it('that failed says why', () => {
    receiver.receive(status)
    expect(state().notices).toHaveLength(1)
    expect(state().notices[0]?.text).toContain('out of memory')
  })

  it('that is under way lists what planning has found, on the lines of the text as it is now', () => {
    const typed = 'program p\nmov a'
    const span = { source: 'programs/place.task', line: 2, column: 1, end_line: 2, end_column: 1 }
    const finding = { code: 'M1', severity: 'error', message: 'too far', hint: '', span, time: null } as const
    receiver.receive({
      ...WELCOME,
      documents: WELCOME.documents.map(one => ({ ...one, text: typed, version: 4 })),
    })
    studio.edit('programs/place.task', `# new\n${typed}`)
    const versions = { 'programs/place.task': 4 }
    receiver.receive({ ...status, state: 'running', findings: [finding], planned: true, versions })
    expect(state().found.map(one => [one.code, one.line])).toEqual([['M1', 3]])
    studio.edit('programs/place.task', typed)
    expect(state().found.map(one => one.line)).toEqual([2])
    studio.edit('programs/place.task', 'program p')
    expect(state().found).toEqual([])
  })

  describe('of a text that has changed since', () => {
    const name = 'programs/place.task'
    const typed = 'program p\ntask T()\nendp\nmov a'
    const mended = `${typed}\nT`
    const versions = { [name]: 4 }
    const span = { source: name, line: 2, column: 1, end_line: 2, end_column: 1 }
    const finding = { severity: 'hint', message: '', hint: '', span, time: null } as const
    const findings = [
      { ...finding, code: 'N238', stage: 'compiling' },
      { ...finding, code: 'S1', stage: 'run' },
    ] as const
    const codes = () => state().problems.map(one => one.code)

    beforeEach(() => {
      receiver.receive({
        ...WELCOME,
        documents: WELCOME.documents.map(one => ({ ...one, text: typed, version: 4 })),
      })
      receiver.receive({ ...status, state: 'running', planned: true, findings, versions })
    })

    it('lists nothing of compiling where the language server answers for the text', () => {
      studio.setChecked([], new Set([name]))
      expect(codes()).toEqual(['N238', 'S1'])
      studio.edit(name, mended)
      expect(codes()).toEqual(['S1'])
      studio.edit(name, typed)
      expect(codes()).toEqual(['N238', 'S1'])
    })

    it('lists what compiling found until the language server answers', () => {
      studio.edit(name, mended)
      expect(codes()).toEqual(['N238', 'S1'])
      studio.setChecked([], new Set(['cell.toml']))
      expect(codes()).toEqual(['N238', 'S1'])
      studio.setChecked([], new Set(['cell.toml', name]))
      expect(codes()).toEqual(['S1'])
    })
  })

  it('that only goes on keeps what was found before', () => {
    const span = { source: 'place', line: 3, column: 1, end_line: 3, end_column: 4 }
    const finding = { code: 'T1', severity: 'error', message: 'no', hint: '', span, time: 2 } as const
    receiver.receive(WELCOME)
    studio.setFindings('run', [finding])
    receiver.receive({ ...status, state: 'running' })
    expect(state().problems).toHaveLength(1)
    receiver.receive({ ...status, state: 'running', planned: true })
    expect(state().problems).toEqual([])
  })

  it('that was refused keeps what the last good run has found', () => {
    const span = { source: 'place', line: 3, column: 1, end_line: 3, end_column: 4 }
    const finding = { code: 'M1', severity: 'error', message: 'far', hint: '', span, time: 2 } as const
    const refusal = { ...finding, code: 'T1', message: 'no', time: null }
    receiver.receive(WELCOME)
    studio.setFindings('run', [finding])
    receiver.receive({ ...status, state: 'refused', findings: [refusal] })
    expect(
      state()
        .problems.map(one => one.code)
        .sort(),
    ).toEqual(['M1', 'T1'])
  })

  it('that was refused lists its errors', () => {
    const span = { source: 'place', line: 3, column: 1, end_line: 3, end_column: 4 }
    const finding = { code: 'T1', severity: 'error', message: 'no', hint: '', span, time: null } as const
    receiver.receive(WELCOME)
    receiver.receive({ ...status, state: 'refused', findings: [finding] })
    expect(state().problems.map(one => [one.document, one.line])).toEqual([['programs/place.task', 3]])
    receiver.receive({ ...status, state: 'running' })
    expect(state().problems).toEqual([])
  })
})

it('a message that this page does not know is passed over', () => {
  const before = state()
  receiver.receive({ type: 'hologram' } as unknown as Message)
  expect(state()).toBe(before)
})
