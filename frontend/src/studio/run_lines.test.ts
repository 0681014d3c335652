import { expect, test } from 'vitest'
import { isOfTexts, RunLines } from './run_lines'

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

test('texts of a moment are those of now while none has changed or is unknown', () => {
  const now = new Map([
    ['cell.toml', 'a'],
    ['main.task', 'b'],
  ])
  expect(isOfTexts(new Map([...now, ['gone.task', 'c']]), now)).toBe(true)
  expect(isOfTexts(new Map([...now, ['main.task', 'c']]), now)).toBe(false)
  expect(isOfTexts(new Map([['cell.toml', 'a']]), now)).toBe(false)
})
