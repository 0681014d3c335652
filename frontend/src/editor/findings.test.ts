import { Text } from '@codemirror/state'
import { describe, expect, it } from 'vitest'
import { marksOf, problemsOf, type WireDiagnostic } from './findings'
import { sanitizeHTML } from './sanitize'

const range = { start: { line: 1, character: 0 }, end: { line: 1, character: 6 } }
const FOUND: WireDiagnostic = {
  range,
  severity: 1,
  code: 'N201',
  message: 'Task not defined: `relase`\ndid you mean `release`?',
  data: {
    hint: 'did you mean `release`?',
    fix: { title: 'replace by `release`', range, newText: 'release' },
  },
}
const doc = Text.of(['program p', 'relase x'])

describe('findings of the language server', () => {
  it('become marks on the same characters', () => {
    const [mark] = marksOf([FOUND], doc, at => at)
    expect(doc.sliceString(mark?.from ?? 0, mark?.to ?? 0)).toBe('relase')
    expect(mark?.severity).toBe('error')
    expect(mark?.source).toBe('N201')
  })

  it('follow what has been typed since', () => {
    const [mark] = marksOf([FOUND], doc, at => at + 3)
    expect([mark?.from, mark?.to]).toEqual([13, 19])
  })

  it('stay inside of a text that has become shorter', () => {
    const [mark] = marksOf([FOUND], Text.of(['a']), at => at)
    expect([mark?.from, mark?.to]).toEqual([1, 1])
  })

  it('offer their quick fix', () => {
    const [mark] = marksOf([FOUND], doc, at => at)
    expect(mark?.actions?.map(one => one.name)).toEqual(['replace by “release”'])
  })

  it('become problems with the hint apart', () => {
    const [problem] = problemsOf([FOUND], 'programs/main.task')
    expect(problem).toMatchObject({
      document: 'programs/main.task',
      line: 2,
      column: 1,
      message: 'Task not defined: `relase`',
      hint: 'did you mean `release`?',
      severity: 'error',
    })
  })
})

describe('a mistake in several places', () => {
  const further = { ...FOUND, data: { ...FOUND.data, firstLine: 2 } }

  it('has a mark at each of them', () => {
    expect(marksOf([FOUND, further], doc, at => at)).toHaveLength(2)
  })

  it('is one problem', () => {
    expect(problemsOf([FOUND, further], 'programs/main.task')).toHaveLength(1)
  })
})

describe('hover texts', () => {
  it('keep the tags of our own Markdown', () => {
    const html =
      '<p><strong>a</strong></p><pre><code class="language-task"><span class="ͼ6">b</span><br></code></pre>'
    expect(sanitizeHTML(html)).toBe(html)
  })

  it.each(['<script>x</script>', '<img src=x onerror=y>', '<p onclick=x>', '<a href="javascript:x">'])(
    'lose %s',
    html => {
      expect(sanitizeHTML(html)).not.toContain('<')
    },
  )
})
