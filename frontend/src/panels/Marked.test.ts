import { createElement } from 'react'
import { renderToStaticMarkup } from 'react-dom/server'
import { expect, test } from 'vitest'
import { Marked } from './Marked'

const shown = (text: string) => renderToStaticMarkup(createElement(Marked, { text }))

test('words between backticks are code, all other signs stand as they are', () => {
  expect(shown('no name `hom`, `a<b`')).toBe('no name <code>hom</code>, <code>a&lt;b</code>')
})

test('a backtick without its fellow stands for itself', () => {
  expect(shown('5` of way')).toBe('5` of way')
})
