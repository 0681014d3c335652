/** Numbers as people read them: SI inside; millimetres and degrees on the page, or what else is chosen. */
import { type UnitChoice, units } from './choice'

/** How a stored unit is shown: `shown = stored × factor`. */
export interface ShownUnit {
  readonly unit: string
  readonly factor: number
  readonly digits: number
}

const DEGREES = 180 / Math.PI
const INCH = 0.0254

const LENGTHS: Readonly<Record<UnitChoice['length'], ShownUnit>> = {
  mm: { unit: 'mm', factor: 1000, digits: 1 },
  m: { unit: 'm', factor: 1, digits: 4 },
  in: { unit: 'in', factor: 1 / INCH, digits: 3 },
}

const ANGLES: Readonly<Record<UnitChoice['angle'], ShownUnit>> = {
  deg: { unit: '°', factor: DEGREES, digits: 2 },
  rad: { unit: 'rad', factor: 1, digits: 4 },
}

const SHOWN: Readonly<Record<string, ShownUnit>> = {
  N·m: { unit: 'N·m', factor: 1, digits: 2 },
  N: { unit: 'N', factor: 1, digits: 1 },
  A: { unit: 'A', factor: 1, digits: 2 },
  V: { unit: 'V', factor: 1, digits: 1 },
  W: { unit: 'W', factor: 1, digits: 1 },
  Pa: { unit: 'bar', factor: 1e-5, digits: 1 },
  kg: { unit: 'kg', factor: 1, digits: 2 },
  s: { unit: 's', factor: 1, digits: 2 },
}

export function shownUnit(unit: string): ShownUnit {
  const [, base = '', per = ''] = /^(rad|m)(\/s²?)?$/.exec(unit) ?? []
  if (!base) return SHOWN[unit] ?? { unit, factor: 1, digits: 3 }
  const { length, angle } = units()
  const shown = base === 'm' ? LENGTHS[length] : ANGLES[angle]
  if (!per) return shown
  // Speeds need no more than a tenth of a millimetre, accelerations less.
  const fewer = base === 'm' && per === '/s' ? 0 : per === '/s' ? 1 : 2
  return { ...shown, unit: shown.unit + per, digits: Math.max(0, shown.digits - fewer) }
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
