import { expect, test } from 'vitest'
import type { Finding, Run, RunEvent } from '../run/run'
import { documentOfSource } from './document_names'
import { nearestPass, passesOf } from './passes'
import { mergeProblems, type Problem, problemOf } from './problems'

const PROBLEM: Problem = {
  document: 'programs/main.task',
  line: 4,
  column: 2,
  endLine: 4,
  endColumn: 5,
  severity: 'warning',
  code: 'M502',
  message: 'too fast',
  hint: '',
  time: null,
}

const FINDING: Finding = {
  code: 'X993',
  severity: 'warning',
  message: 'joints stand still',
  hint: '',
  span: null,
  time: null,
}

test('errors come first, then documents and lines in order', () => {
  const later = { ...PROBLEM, line: 9, severity: 'error' } as const
  const other = { ...PROBLEM, document: 'cell.toml' }
  const merged = mergeProblems(new Map([['lsp', [PROBLEM, other, later]]]))
  expect(merged).toEqual([later, other, PROBLEM])
})

test('what two sources say of one place is listed once', () => {
  const sources = new Map([
    ['lsp', [PROBLEM]],
    ['compile', [{ ...PROBLEM, hint: 'slower' }]],
  ])
  expect(mergeProblems(sources)).toEqual([PROBLEM])
})

test('one source may say several things of one place, but nothing twice', () => {
  const stop = { ...PROBLEM, code: 'M560', message: 'the arm stops: it turns back' }
  const other = { ...stop, message: 'the arm stops: the program waits' }
  expect(mergeProblems(new Map([['run', [stop, other, { ...stop }]]]))).toEqual([stop, other])
  expect(
    mergeProblems(
      new Map([
        ['lsp', [stop]],
        ['run', [other]],
      ]),
    ),
  ).toEqual([stop])
})

test('a finding in a file that is no document has the name of the file', () => {
  const span = { source: '/cells/one/robots/arm.urdf', line: 104, column: 3, end_line: 104, end_column: 9 }
  const finding = { ...FINDING, span }
  expect(problemOf(finding, () => '')).toMatchObject({ document: '', file: 'arm.urdf', line: 104 })
  expect(problemOf(finding, () => 'cell.toml').file).toBeUndefined()
  const other = problemOf({ ...finding, span: { ...span, source: 'robots/hand.urdf' } }, () => '')
  expect(mergeProblems(new Map([['scene', [problemOf(finding, () => ''), other]]]))).toHaveLength(2)
})

test('findings at two times are two', () => {
  const twice = [
    { ...PROBLEM, time: 1 },
    { ...PROBLEM, time: 2 },
  ]
  expect(mergeProblems(new Map([['run', twice]]))).toHaveLength(2)
})

test('findings without a place are told apart by their words', () => {
  const nowhere = { ...PROBLEM, document: '', line: 0, column: 0 }
  const sources = new Map([['scene', [nowhere, { ...nowhere, message: 'another mesh is missing' }]]])
  expect(mergeProblems(sources)).toHaveLength(2)
})

test.each([
  ['programs/main.task', 'programs/main.task'],
  ['/some/place/cell/programs/main.task', 'programs/main.task'],
  ['C:\\cells\\one\\programs\\main.task', 'programs/main.task'],
  ['main.task', 'programs/main.task'],
  ['main', 'programs/main.task'],
  ['/some/place/cell/cell.toml', 'cell.toml'],
  ['elsewhere', ''],
])('the source %s means the document %s', (source, document) => {
  const documents = [{ name: 'cell.toml' }, { name: 'programs/main.task' }]
  expect(documentOfSource(source, documents)).toBe(document)
})

function runOf(events: readonly Partial<RunEvent>[]): Run {
  const span = { source: 'main', line: 5, column: 1, end_line: 5, end_column: 9 }
  return { events: events.map(one => ({ kind: 'move', text: '', data: {}, span, ...one })) } as unknown as Run
}

const any = () => true

test('a line has one pass for each time that it did something', () => {
  const run = runOf([
    { time: 1, duration: 2 },
    { time: 7, duration: 1 },
  ])
  expect(passesOf(run, any, 5)).toEqual([
    { from: 1, to: 3 },
    { from: 7, to: 8 },
  ])
  expect(passesOf(run, any, 6)).toEqual([])
  expect(passesOf(run, () => false, 5)).toEqual([])
})

test('a called task and its first move on one line are one pass', () => {
  const run = runOf([
    { kind: 'task', time: 1, duration: 6 },
    { time: 1, duration: 2 },
  ])
  expect(passesOf(run, any, 5)).toEqual([{ from: 1, to: 7 }])
})

test('inputs are no work of a line', () => {
  expect(passesOf(runOf([{ kind: 'input', time: 1, duration: 0 }]), any, 5)).toEqual([])
})

test('the pass under way counts, else the nearest', () => {
  const passes = [
    { from: 1, to: 3 },
    { from: 7, to: 8 },
  ]
  expect([0, 2, 4, 6, 7.5, 99].map(time => nearestPass(passes, time))).toEqual([0, 0, 0, 1, 1, 1])
  expect(nearestPass([], 1)).toBe(-1)
})
