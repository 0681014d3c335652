import { expect, test } from 'vitest'
import { exportName } from './document_names'

test('a file that is exported is named by project and program, each once', () => {
  expect(exportName('my_cell', 'main')).toBe('my_cell-main')
  expect(exportName('fig5', 'fig5')).toBe('fig5')
  expect(exportName('my_cell', '')).toBe('my_cell')
  expect(exportName('', '')).toBe('run')
})

test('its name holds nothing that a file name may not hold', () => {
  expect(exportName('Zelle 3/links', 'Größe:2')).toBe('Zelle-3-links-Größe-2')
})
