import { expect, test } from 'vitest'
import { RunLines } from './run_lines'

const OLD = 'mov a\nmovs b\nmov c'

function linesOf(text: string): RunLines {
  const lines = new RunLines({
    text: () => text,
    documentOf: source => (source === 'main.task' ? 'programs/main.task' : ''),
  })
  lines.showRun(new Map([['programs/main.task', OLD]]))
  return lines
}

test('a line of the run is found where it stands now', () => {
  const lines = linesOf(`// a new head\n\n${OLD}`)
  expect(lines.place('main.task', 2)).toEqual({ document: 'programs/main.task', line: 4 })
})

test('a line that is gone from the text has no place', () => {
  expect(linesOf('mov a\nmov c').place('main.task', 2)).toBeNull()
})

test('no line and a source that is no document have no place', () => {
  expect(linesOf(OLD).place('main.task', 0)).toBeNull()
  expect(linesOf(OLD).place('elsewhere.task', 1)).toBeNull()
})
