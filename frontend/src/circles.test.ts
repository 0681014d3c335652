import { posix } from 'node:path'
import { describe, expect, it } from 'vitest'

type Graph = ReadonlyMap<string, readonly string[]>

const IMPORT = /\b(?:from|import)\s*\(?\s*'(\.{1,2}\/[^']+)'/g

/** What each file imports of the others, also for types only and inside functions. */
function imports(files: Readonly<Record<string, string>>): Graph {
  const found = (from: string, to: string): string[] => {
    const path = posix.join(posix.dirname(from), to)
    return [path, `${path}.ts`, `${path}.tsx`].filter(one => one in files)
  }
  return new Map(
    Object.entries(files).map(([file, text]) => [
      file,
      [...text.matchAll(IMPORT)].flatMap(([, to = '']) => found(file, to)),
    ]),
  )
}

/** The files of a circle, the first one twice, or nothing. */
function circle(graph: Graph): string[] {
  const done = new Set<string>()
  const from = (file: string, way: readonly string[]): string[] => {
    if (way.includes(file)) return [...way.slice(way.indexOf(file)), file]
    if (done.has(file)) return []
    const found = (graph.get(file) ?? []).map(next => from(next, [...way, file])).find(one => one.length > 0)
    done.add(file)
    return found ?? []
  }
  return [...graph.keys()].map(file => from(file, [])).find(one => one.length > 0) ?? []
}

describe('a file that needs itself over others', () => {
  it.each([
    "import type { A } from './a'",
    "import {\n  a,\n} from '../x/a'",
    "export { a } from './a'",
    "void import('./a')",
  ])('is found: %s', line => {
    expect(circle(imports({ 'x/a.ts': "import { b } from './b'", 'x/b.tsx': line }))).toHaveLength(3)
  })

  it('is not in these sources', () => {
    const files = import.meta.glob<string>('./**/*.{ts,tsx}', {
      query: '?raw',
      import: 'default',
      eager: true,
    })
    const graph = imports(
      Object.fromEntries(Object.entries(files).map(([path, text]) => [posix.normalize(path), text])),
    )
    expect([...graph.values()].flat().length).toBeGreaterThan(300)
    expect(circle(graph)).toEqual([])
  })
})
