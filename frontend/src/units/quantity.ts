/** Numbers as people read them: SI inside; millimetres, degrees and seconds on the page. */

/** How a stored unit is shown: `shown = stored × factor`. */
export interface ShownUnit {
  readonly unit: string
  readonly factor: number
  readonly digits: number
}

const DEGREES = 180 / Math.PI

const SHOWN: Readonly<Record<string, ShownUnit>> = {
  rad: { unit: '°', factor: DEGREES, digits: 2 },
  'rad/s': { unit: '°/s', factor: DEGREES, digits: 1 },
  'rad/s²': { unit: '°/s²', factor: DEGREES, digits: 0 },
  m: { unit: 'mm', factor: 1000, digits: 1 },
  'm/s': { unit: 'mm/s', factor: 1000, digits: 1 },
  N·m: { unit: 'N·m', factor: 1, digits: 2 },
  N: { unit: 'N', factor: 1, digits: 1 },
  A: { unit: 'A', factor: 1, digits: 2 },
  V: { unit: 'V', factor: 1, digits: 1 },
  kg: { unit: 'kg', factor: 1, digits: 2 },
  s: { unit: 's', factor: 1, digits: 2 },
}

export function shownUnit(unit: string): ShownUnit {
  return SHOWN[unit] ?? { unit, factor: 1, digits: 3 }
}

/** A stored number without its unit; a dash where there is none. */
export function formatNumber(value: number, unit: string): string {
  if (!Number.isFinite(value)) return '–'
  const { factor, digits } = shownUnit(unit)
  const text = (value * factor).toFixed(digits)
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text
}

/** A stored number with its unit: `12.5 mm`, `90.00°`. */
export function formatQuantity(value: number, unit: string): string {
  const shown = shownUnit(unit).unit
  const gap = shown.startsWith('°') || shown === '' ? '' : ' '
  return `${formatNumber(value, unit)}${gap}${shown}`
}

/** Whole numbers and switches need no decimals. */
export function formatPlain(value: number): string {
  if (!Number.isFinite(value)) return '–'
  return Number.isInteger(value) ? String(value) : value.toFixed(3)
}
