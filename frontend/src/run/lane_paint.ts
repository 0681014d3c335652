/** Drawing the scale and the lanes of the timeline. */
import type { Bar, Lane } from './lanes'
import { tickLabel, tickStep, ticks } from './ticks'
import type { TimeWindow } from './time_window'

export const SCALE_HEIGHT = 16
/** Heights of lanes [px]. */
export const LANE_HEIGHT: Readonly<Record<Lane['kind'], number>> = {
  findings: 14,
  tasks: 13,
  steps: 13,
  held: 13,
  inputs: 12,
}

/** Ticks with numbers are at least so far from each other [px]. */
const TICK_ROOM = 64
/** A wait is a thin line [px]. */
const WAIT_HEIGHT = 3
const GROUNDS: Readonly<Record<Bar['tone'], string>> = {
  task: '--accent',
  move: '--accent',
  act: '--accent',
  wait: '--quiet',
  held: '--good',
  slowed: '--warning',
}
/** Shorter bars have no words in them [px]. */
const WORD_ROOM = 22
const FONT = '10.5px system-ui, "DejaVu Sans", sans-serif'

export interface Canvas {
  readonly context: CanvasRenderingContext2D
  readonly width: number
  readonly window: TimeWindow
  readonly colour: (name: string) => string
}

export function paintScale(canvas: Canvas, height: number): void {
  const { context, width, window, colour } = canvas
  // Without a run there is no time to write.
  if (window.to <= window.from) return
  const step = tickStep(width / Math.max(window.to - window.from, 1e-9), TICK_ROOM)
  context.font = FONT
  context.textBaseline = 'top'
  for (const time of ticks(window.from, window.to, step)) {
    const x = Math.round(window.x(time, width))
    context.fillStyle = colour('--line')
    context.fillRect(x, 0, 1, height)
    const label = tickLabel(time, step)
    const room = context.measureText(label).width
    if (x + 3 + room > width) continue
    context.fillStyle = colour('--quiet')
    context.fillText(label, x + 3, 2)
  }
  context.fillStyle = colour('--line')
  context.fillRect(0, SCALE_HEIGHT - 1, width, 1)
}

export function paintLane(canvas: Canvas, lane: Lane, top: number): void {
  const height = LANE_HEIGHT[lane.kind]
  for (const bar of lane.bars) paintBar(canvas, lane, bar, top + 1, height - 2)
  const { context, width, window, colour } = canvas
  for (const found of lane.findings) {
    const x = window.x(found.time, width)
    if (x < -6 || x > width + 6) continue
    context.fillStyle = colour(`--${found.severity === 'hint' ? 'info' : found.severity}`)
    paintFinding(context, found.severity, x, top + height / 2)
  }
  context.fillStyle = colour('--ghost')
  for (const input of lane.inputs) {
    const x = window.x(input.time, width)
    context.fillRect(x - 1, top + 1, 2, height - 2)
    context.fillRect(x - 3, top + height - 4, 6, 3)
  }
}

function paintBar(canvas: Canvas, lane: Lane, bar: Bar, top: number, height: number): void {
  const { context, width, window, colour } = canvas
  const left = window.x(bar.from, width)
  const right = window.x(bar.to, width)
  if (right < 0 || left > width) return
  // A gap of a pixel between neighbours, where there is room for one.
  const wide = Math.max(right - left - (right - left > 4 ? 1 : 0), 1)
  context.globalAlpha = { task: 0.45, move: 0.75, act: 0.35, wait: 0.6, held: 0.45, slowed: 0.45 }[bar.tone]
  context.fillStyle = colour(GROUNDS[bar.tone])
  if (bar.tone === 'wait') context.fillRect(left, top + (height - WAIT_HEIGHT) / 2, wide, WAIT_HEIGHT)
  else context.fillRect(left, top, wide, height)
  context.globalAlpha = 1
  // Names of tasks stand beside their lanes.
  if (lane.kind !== 'held') return
  const seen = Math.max(left, 0)
  const room = Math.min(right, width) - seen - 6
  if (room < WORD_ROOM - 6) return
  context.font = FONT
  context.textBaseline = 'middle'
  context.fillStyle = colour('--text')
  const text = fitting(context, bar.text, room)
  if (text) context.fillText(text, seen + 3, top + height / 2 + 0.5)
}

/** As much of a text as fits, with dots for the rest; empty where not even three letters do. */
function fitting(context: CanvasRenderingContext2D, text: string, room: number): string {
  if (context.measureText(text).width <= room) return text
  for (let length = text.length - 1; length >= 3; length--) {
    const part = `${text.slice(0, length)}…`
    if (context.measureText(part).width <= room) return part
  }
  return ''
}

/** The shape tells the severity without its colour: a cross-wise square, a triangle, a dot. */
function paintFinding(context: CanvasRenderingContext2D, severity: string, x: number, y: number): void {
  context.beginPath()
  if (severity === 'error') {
    context.moveTo(x, y - 6)
    context.lineTo(x + 6, y)
    context.lineTo(x, y + 6)
    context.lineTo(x - 6, y)
  } else if (severity === 'warning') {
    context.moveTo(x, y - 5)
    context.lineTo(x + 5.5, y + 5)
    context.lineTo(x - 5.5, y + 5)
  } else {
    context.arc(x, y, 4, 0, 2 * Math.PI)
  }
  context.fill()
}
