import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { type Block, blocksOf, inlinesOf, matchingSections, sectionsOf, slug } from './markdown'

const page = (name: string) =>
  readFileSync(new URL(`../../../docs/reference/${name}`, import.meta.url), 'utf8')

test('blocks are told apart', () => {
  const text =
    '# A `b`\n\none\ntwo\n\n- x\n  y\n- z\n\n| h | `a\\|b` |\n|---|---|\n| 1 | 2 |\n\n```task\nmov home\n```\n'
  expect(blocksOf(text).map(one => one.kind)).toEqual(['heading', 'paragraph', 'list', 'table', 'code'])
  expect(blocksOf(text)[2]).toEqual({
    kind: 'list',
    ordered: false,
    items: [[{ kind: 'text', text: 'x y' }], [{ kind: 'text', text: 'z' }]],
  })
  expect(blocksOf(text)[3]).toMatchObject({ head: [[{ text: 'h' }], [{ kind: 'code', text: 'a|b' }]] })
  expect(blocksOf(text)[4]).toEqual({ kind: 'code', language: 'task', text: 'mov home' })
})

test('code, emphasis and links inside a line', () => {
  expect(inlinesOf('see `a * b`, **strong** and [it](x.md#y)')).toEqual([
    { kind: 'text', text: 'see ' },
    { kind: 'code', text: 'a * b' },
    { kind: 'text', text: ', ' },
    { kind: 'strong', text: 'strong' },
    { kind: 'text', text: ' and ' },
    { kind: 'link', text: 'it', target: 'x.md#y' },
  ])
})

test('markup in a page stays text', () => {
  const [block] = blocksOf('<img src=x onerror=alert(1)> <script>1</script>')
  expect(block).toEqual({
    kind: 'paragraph',
    text: [{ kind: 'text', text: '<img src=x onerror=alert(1)> <script>1</script>' }],
  })
})

test('headings are named as links name them', () => {
  expect(slug('[tools.NAME]')).toBe('toolsname')
  expect(slug('Gripper, signals, waiting')).toBe('gripper-signals-waiting')
})

test.each(['language.md', 'cell-file.md', 'commands.md'])('every link inside %s leads to a heading', name => {
  const sections = sectionsOf(page(name))
  const ids = sections.map(one => one.id)
  const links = JSON.stringify(sections).matchAll(/"target":"#([^"]+)"/g)
  for (const [, id] of links) expect(ids).toContain(id)
})

test('nothing of the pages is lost', () => {
  for (const name of ['language.md', 'cell-file.md', 'commands.md']) {
    const text = page(name)
    const found = JSON.stringify(blocksOf(text))
    for (const [, word] of text.matchAll(/\b([a-z]{9,})\b/g)) expect(found).toContain(word)
    const fences = text.split('\n').filter(line => line.startsWith('```')).length
    expect(blocksOf(text).filter((one: Block) => one.kind === 'code').length).toBeGreaterThanOrEqual(
      fences / 2,
    )
  }
})

test('a search finds the section by words of its text', () => {
  const found = matchingSections(sectionsOf(page('language.md')), 'wait UNTIL timeout')
  expect(found.map(one => one.title)).toContain('Gripper, signals, waiting')
  expect(matchingSections(sectionsOf(page('language.md')), 'xyzzy')).toEqual([])
})
