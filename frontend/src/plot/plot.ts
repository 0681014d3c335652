/** Columns of a run over time. Click to go to a time, drag the time line to scrub, drag elsewhere to zoom. */
import uPlot from 'uplot'
import type { Cursor } from '../run/cursor'
import type { Run } from '../run/run'
import { onScheme } from '../style/scheme'
import { onUnits } from '../units/choice'
import { formatQuantity, shownUnit } from '../units/quantity'
import { letGrasp } from './grasp'
import { Legend } from './legend'
import { axesOf, traceColours } from './style'
import { joinPoints } from './table'
import { type PlotColumn, pointsOf, scaleOf, type Trace, tracesOf, unitsOf } from './traces'
import { words } from './words'
import 'uplot/dist/uPlot.min.css'
import './plot.css'

export type { PlotColumn } from './traces'

/** Values beside the names are written this often [ms]. */
const PERIOD = 50

export class Plot {
  readonly #host: HTMLElement
  readonly #cursor: Cursor
  readonly #area = document.createElement('div')
  readonly #line = document.createElement('div')
  readonly #legend: Legend
  readonly #stops: (() => void)[] = []
  #run: Run | null = null
  #traces: readonly Trace[] = []
  #range: readonly [number, number] | null = null
  #chart: uPlot | null = null
  #written = Number.NEGATIVE_INFINITY
  #timer: ReturnType<typeof setTimeout> | null = null

  constructor(host: HTMLElement, cursor: Cursor) {
    this.#host = host
    this.#cursor = cursor
    this.#area.className = 'plot-area'
    this.#area.setAttribute('role', 'img')
    this.#line.className = 'plot-time'
    this.#legend = new Legend()
    host.classList.add('plot')
    host.append(this.#legend.element, this.#area)
    const sizes = new ResizeObserver(() => this.#resize())
    sizes.observe(this.#area)
    this.#stops.push(
      cursor.onTime(() => this.#follow()),
      () => sizes.disconnect(),
      onScheme(() => this.#rebuild()),
      onUnits(() => this.#rebuild()),
    )
    this.#rebuild()
  }

  /** Show these columns of a run; the zoomed stretch stays as long as the run has something there. */
  show(run: Run | null, columns: readonly PlotColumn[]): void {
    const traces = run ? tracesOf(run, columns) : []
    const same = JSON.stringify(traces) === JSON.stringify(this.#traces)
    this.#run = run
    this.#traces = traces
    if (this.#range && this.#range[0] >= (run?.duration ?? 0)) this.#range = null
    if (same && this.#chart) this.refresh()
    else this.#rebuild()
  }

  /** Draw again: a live run has grown. */
  refresh(): void {
    const chart = this.#chart
    const run = this.#run
    if (!chart || !run) return
    chart.setData(this.#data(run))
    this.#tell()
  }

  /** The whole time again. */
  unzoom(): void {
    this.#range = null
    this.refresh()
  }

  /** Where the time line is drawn and where the scale has the time [px]; null where nothing is plotted. */
  get timeLine(): { readonly drawn: number; readonly scale: number; readonly inside: boolean } | null {
    const chart = this.#chart
    if (!chart) return null
    const drawn = this.#line.getBoundingClientRect()
    return {
      drawn: drawn.left + drawn.width / 2 - chart.over.getBoundingClientRect().left,
      scale: chart.valToPos(this.#cursor.time, 'x'),
      inside: this.#line.style.visibility !== 'hidden',
    }
  }

  destroy(): void {
    for (const stop of this.#stops) stop()
    if (this.#timer) clearTimeout(this.#timer)
    this.#chart?.destroy()
    this.#host.replaceChildren()
  }

  #rebuild(): void {
    this.#chart?.destroy()
    this.#chart = null
    const names = this.#traces.map(one => one.name).join(', ')
    this.#area.setAttribute('aria-label', words.name(names))
    const colours = traceColours(this.#host, this.#traces.length)
    this.#legend.show(this.#traces.map((one, at) => ({ ...one, colour: colours[at] ?? '' })))
    this.#area.dataset.empty = this.#traces.length ? '' : words.none
    const run = this.#run
    if (!run || this.#traces.length === 0) return
    const chart = new uPlot(
      {
        width: Math.max(this.#area.clientWidth, 80),
        height: Math.max(this.#area.clientHeight, 60),
        legend: { show: false },
        scales: { x: { time: false, range: () => [...this.#span()] } },
        axes: axesOf(this.#host, unitsOf(this.#traces)),
        padding: [8, 12, 0, 0],
        cursor: { drag: { x: true, y: false, setScale: false, dist: 6 }, points: { show: false }, y: false },
        series: [
          {},
          ...this.#traces.map((one, at) => ({
            label: one.name,
            scale: scaleOf(one),
            stroke: colours[at] ?? '#888',
            width: 1.5,
            pxAlign: 0,
            points: { show: false },
            ...(stepped && one.held ? { paths: stepped } : {}),
          })),
        ],
        // Scales change a moment after the data that asked for it; only then the time has its new place.
        hooks: { setSelect: [self => this.#zoom(self)], draw: [() => this.#place()] },
      },
      this.#data(run),
      this.#area,
    )
    this.#chart = chart
    chart.over.append(this.#line)
    letGrasp(chart, this.#cursor)
    chart.over.addEventListener('click', event => this.#click(event))
    chart.over.addEventListener('dblclick', () => this.unzoom())
    this.#follow()
  }

  /** Times that are shown [s]. */
  #span(): readonly [number, number] {
    return this.#range ?? [0, Math.max(this.#run?.duration ?? 0, 1e-3)]
  }

  #data(run: Run): uPlot.AlignedData {
    const [from, to] = this.#span()
    const width = Math.max(this.#area.clientWidth, 80)
    const points = this.#traces.map(trace => pointsOf(run, trace, [from, to], width))
    const { times, columns } = joinPoints(
      points,
      this.#traces.map(one => shownUnit(one.unit).factor),
    )
    return [times, ...columns]
  }

  #zoom(chart: uPlot): void {
    const { left, width } = chart.select
    if (width < 6) return
    this.#range = [chart.posToVal(left, 'x'), chart.posToVal(left + width, 'x')]
    chart.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false)
    this.refresh()
  }

  #click(event: MouseEvent): void {
    const chart = this.#chart
    if (chart) this.#cursor.seek(chart.posToVal(event.offsetX, 'x'))
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#area
    if (!this.#chart || width < 40 || height < 40) return
    this.#chart.setSize({ width, height })
    this.refresh()
  }

  /** The time line at once, values beside the names a little later. */
  #follow(): void {
    this.#place()
    this.#tell()
  }

  /** Put the time line where the chart's present scale has the time. */
  #place(): void {
    const chart = this.#chart
    if (!chart) return
    const left = chart.valToPos(this.#cursor.time, 'x')
    const inside = left >= 0 && left <= chart.over.clientWidth
    this.#line.style.transform = `translateX(${Math.round(left)}px)`
    this.#line.style.visibility = inside ? 'inherit' : 'hidden'
  }

  #tell(): void {
    if (!this.#chart || this.#timer) return
    const wait = this.#written + PERIOD - performance.now()
    if (wait <= 0) this.#write()
    else
      this.#timer = setTimeout(() => {
        this.#timer = null
        this.#write()
      }, wait)
  }

  #write(): void {
    this.#written = performance.now()
    const run = this.#run
    if (!run) return
    const time = this.#cursor.time
    this.#legend.write(
      this.#traces.map(({ column, unit }) =>
        formatQuantity(run.value(column.channel, column.column, time), unit),
      ),
    )
  }
}

const stepped = uPlot.paths.stepped?.({ align: 1 })
