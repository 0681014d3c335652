import { expect, test, vi } from 'vitest'
import { letGo } from './let_go'

test('a switch that a pointer has clicked gives up the focus', () => {
  const blur = vi.fn()
  letGo({ detail: 1, currentTarget: { blur } })
  expect(blur).toHaveBeenCalledOnce()
})

test('a switch that a key has pressed keeps the focus', () => {
  const blur = vi.fn()
  letGo({ detail: 0, currentTarget: { blur } })
  expect(blur).not.toHaveBeenCalled()
})
