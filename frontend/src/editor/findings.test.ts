import { EditorState, Text, type TransactionSpec } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'
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

describe('a fix of more than the marked text', () => {
  const whole = { start: { line: 1, character: 0 }, end: { line: 1, character: 8 } }
  const fix = { title: 'replace by `lin x`', range: whole, newText: 'lin x' }
  const [mark] = marksOf([{ ...FOUND, data: { fix } }], doc, at => at)

  function done(text: string, from: number): string {
    let state = EditorState.create({ doc: text })
    const dispatch = (spec: TransactionSpec) => {
      state = state.update(spec).state
    }
    const view = { state, dispatch } as unknown as EditorView
    mark?.actions?.[0]?.apply(view, from, from + 6)
    return state.doc.toString()
  }

  it('is made where that text has moved to', () => {
    expect(done('program p\n\nrelase x\nrelase x', 11)).toBe('program p\n\nlin x\nrelase x')
  })

  it('is left where that text is another one now', () => {
    expect(done('program p\nrelase y', 10)).toBe('program p\nrelase y')
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
