/** Colours and axes of plots, from the style sheet's variables; the fallbacks suit a light page. */
import type uPlot from 'uplot'
import { words } from './words'

/** Colour-blind safe, told apart also by lightness. */
const TRACES = ['#0072b2', '#d05000', '#00804a', '#d8409c', '#9a7a00', '#1f262e', '#7030b8', '#868f9a']
const FONT = '11px system-ui, sans-serif'

function variable(host: HTMLElement, name: string, fallback: string): string {
  return getComputedStyle(host).getPropertyValue(name).trim() || fallback
}

export function traceColours(host: HTMLElement, count: number): readonly string[] {
  return Array.from({ length: count }, (_, at) => {
    const place = at % TRACES.length
    return variable(host, `--trace-${place + 1}`, TRACES[place] ?? '#555555')
  })
}

/** Time below, the first unit on the left, further ones on the right. */
export function axesOf(host: HTMLElement, units: readonly string[]): uPlot.Axis[] {
  const text = variable(host, '--quiet', '#5a6472')
  const grid = { stroke: variable(host, '--line', '#d8dde4'), width: 1 }
  const common = {
    stroke: text,
    font: FONT,
    labelFont: FONT,
    labelSize: 16,
    ticks: { ...grid, size: 4 },
    gap: 3,
  }
  return [
    { ...common, grid, label: words.time, size: 24 },
    ...units.map((unit, at) => ({
      ...common,
      scale: unit,
      label: words.axis(unit === '1' ? '' : unit),
      side: at === 0 ? 3 : 1,
      grid: at === 0 ? grid : { show: false },
      size: 46,
    })),
  ]
}
