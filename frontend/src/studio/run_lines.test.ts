import { expect, test } from 'vitest'
import { isOfTexts, NOW, RunLines } from './run_lines'

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

test('a live run that stays the result is of an older text, seen by this page or not', () => {
  const lines = linesOf(OLD)
  expect([lines.isOlder, lines.changed]).toEqual([false, false])
  lines.showRun(NOW, 'older')
  expect([lines.isOlder, lines.changed]).toEqual([true, true])
})

test('a run knows whether its texts have changed since, and which texts it is of', () => {
  const now = (text: string) => new Map([['programs/main.task', text]])
  expect([linesOf(OLD).changed, linesOf(`${OLD} `).changed]).toEqual([false, true])
  expect([linesOf(OLD).isOf(now(OLD)), linesOf(OLD).isOf(now('mov a'))]).toEqual([true, false])
})

test('what follows from a line goes along with it, and stands alone where that is gone', () => {
  const span = { source: 'main.task', line: 3, column: 1, end_line: 3, end_column: 6 }
  const follows = { source: 'main.task', line: 2 }
  const finding = {
    code: 'S721',
    severity: 'warning',
    message: '',
    hint: '',
    span,
    time: 1,
    follows,
  } as const
  const texts = new Map([['programs/main.task', OLD]])
  const causeIn = (text: string) => linesOf(text).problems([finding], texts)[0]?.follows
  expect(causeIn(`# new\n${OLD}`)).toEqual({ document: 'programs/main.task', line: 3 })
  expect(causeIn('mov a\nmov c')).toBeUndefined()
})
