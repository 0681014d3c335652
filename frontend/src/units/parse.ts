/** Typed quantities: `12.5 mm`, `90 deg`, `13*2`, `(1+2)/3 in`. */
import { shownUnit } from './quantity'

export type Dimension = 'length' | 'angle'

export type Parsed = { readonly value: number } | { readonly mistake: string }

const UNITS: Readonly<Record<Dimension, Readonly<Record<string, number>>>> = {
  length: { mm: 1e-3, cm: 1e-2, m: 1, in: 0.0254, '"': 0.0254 },
  angle: { deg: Math.PI / 180, '°': Math.PI / 180, rad: 1 },
}

const SI: Readonly<Record<Dimension, string>> = { length: 'm', angle: 'rad' }

/** Read what was typed as metres or radians; a number without unit is in the units that are shown. */
export function parseQuantity(text: string, dimension: Dimension): Parsed {
  const match = /^(.*?)\s*([a-zA-Z°"]*)\s*$/.exec(text.trim())
  const sum = match?.[1]?.trim() ?? ''
  const unit = match?.[2] ?? ''
  const known = UNITS[dimension]
  const named = Object.hasOwn(known, unit) ? known[unit] : undefined
  const factor = unit === '' ? 1 / shownUnit(SI[dimension]).factor : named
  if (factor === undefined) {
    return { mistake: `“${unit}” is no unit here; use ${Object.keys(known).join(', ')}` }
  }
  const number = calculate(sum.replaceAll('−', '-').replaceAll(',', '.'))
  if (number === null) return { mistake: `“${text.trim()}” is no number; write 12.5, 13*2 or 90 deg` }
  return { value: number * factor }
}

/** The value of a sum of + - * / and brackets; null where it is none. */
export function calculate(text: string): number | null {
  const tokens = text.match(/\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+|[-+*/()]|\S/g) ?? []
  let at = 0
  const term = (): number => {
    const token = tokens[at++]
    if (token === '-') return -term()
    if (token === '+') return term()
    if (token === '(') {
      const inner = sum()
      return tokens[at++] === ')' ? inner : Number.NaN
    }
    return token !== undefined && /^[\d.]/.test(token) ? Number(token) : Number.NaN
  }
  const product = (): number => {
    let value = term()
    while (tokens[at] === '*' || tokens[at] === '/')
      value = tokens[at++] === '*' ? value * term() : value / term()
    return value
  }
  const sum = (): number => {
    let value = product()
    while (tokens[at] === '+' || tokens[at] === '-')
      value = tokens[at++] === '+' ? value + product() : value - product()
    return value
  }
  const value = sum()
  return at === tokens.length && Number.isFinite(value) ? value : null
}
