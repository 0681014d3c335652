import { ensureSyntaxTree } from '@codemirror/language'
import { EditorState } from '@codemirror/state'
import { highlightTree, tagHighlighter, tags } from '@lezer/highlight'
import { expect, test } from 'vitest'
import { toml } from './toml_language'

const seen = tagHighlighter([
  { tag: tags.heading, class: 'heading' },
  { tag: tags.propertyName, class: 'key' },
  { tag: tags.number, class: 'number' },
  { tag: tags.string, class: 'string' },
  { tag: tags.bool, class: 'bool' },
  { tag: tags.comment, class: 'comment' },
  { tag: tags.invalid, class: 'invalid' },
])

/** The coloured pieces of a text, as `class:piece`. */
function coloured(doc: string): readonly string[] {
  const state = EditorState.create({ doc, extensions: [toml()] })
  const tree = ensureSyntaxTree(state, doc.length, 5000)
  const found: string[] = []
  if (tree) highlightTree(tree, seen, (from, to, name) => found.push(`${name}:${doc.slice(from, to)}`))
  return found
}

test('tables, keys and values of each kind are told apart', () => {
  expect(coloured('[robot] # the arm\nmodel = "puma560"\nscale = -1.5e3\n"odd key" = true')).toEqual([
    'heading:[robot]',
    'comment:# the arm',
    'key:model',
    'string:"puma560"',
    'key:scale',
    'number:-1.5e3',
    'key:odd key"'.replace('odd', '"odd'),
    'bool:true',
  ])
})

test('arrays of tables are headings, arrays are values', () => {
  expect(coloured('[[parts]]\nat = [1, "mm", [2.0]]')).toEqual([
    'heading:[[parts]]',
    'key:at',
    'number:1',
    'string:"mm"',
    'number:2.0',
  ])
})

test('inline tables have keys, also behind a comma', () => {
  expect(coloured('pose = { x = 1, turn = [0, 90], y = 2 }')).toEqual([
    'key:pose',
    'key:x',
    'number:1',
    'key:turn',
    'number:0',
    'number:90',
    'key:y',
    'number:2',
  ])
})

test('an array may go over several lines, and ends', () => {
  expect(coloured('at = [\n  1,\n  2, # two\n]\nnext = 3')).toEqual([
    'key:at',
    'number:1',
    'number:2',
    'comment:# two',
    'key:next',
    'number:3',
  ])
})

test('a long string goes on until its quotes, a mark of a comment in it is text', () => {
  expect(coloured('text = """a # b\nc"""\nk = 1')).toEqual([
    'key:text',
    'string:"""a # b',
    'string:c"""',
    'key:k',
    'number:1',
  ])
})

test('a word where a value must stand is shown as wrong', () => {
  expect(coloured('model = puma560')).toEqual(['key:model', 'invalid:puma560'])
})
