/** One plot: its channels, and the drawing of it. */
import type { IDockviewPanelProps } from 'dockview-react'
import { useEffect, useRef, useState } from 'react'
import { Plot, type PlotColumn } from '../plot/plot'
import type { Run } from '../run/run'
import { channelOf } from '../run/station'
import { useStudio, useStudioState } from '../studio/context'
import { useEvery } from '../studio/hooks'
import { usePopover } from '../studio/use_popover'
import { words } from '../text/messages'
import { channelName } from '../units/names'
import { ChannelTree } from './ChannelTree'

export function PlotPanel({ api, params }: IDockviewPanelProps) {
  const studio = useStudio()
  const shown = useStudioState(state => state.shown)
  const host = useRef<HTMLDivElement>(null)
  const plot = useRef<Plot | null>(null)
  const [columns, setColumns] = useState<readonly PlotColumn[] | null>(() => readColumns(params?.columns))
  const [choosing, setChoosing] = useState(false)
  const place = useRef<HTMLDivElement>(null)
  usePopover(place, choosing, () => setChoosing(false))
  const run = shown > 0 ? studio.run : null
  const chosen = columns ?? firstColumns(run, studio.stationInSight())
  useEffect(() => {
    if (!host.current) return
    const made = new Plot(host.current, studio.cursor)
    plot.current = made
    studio.plots.add(made)
    return () => {
      studio.plots.delete(made)
      made.destroy()
      plot.current = null
    }
  }, [studio])
  const late = run?.live ? lateChannels(run, chosen) : []
  const key = JSON.stringify(chosen)
  useEffect(() => {
    plot.current?.show(run, JSON.parse(key) as PlotColumn[])
  }, [run, key])
  useEvery(20, () => {
    if (studio.run?.live) plot.current?.refresh()
  })
  const choose = (next: readonly PlotColumn[]) => {
    setColumns(next)
    api.updateParameters({ columns: next })
  }
  return (
    <div className="plot-panel" ref={place}>
      <div className="toolbar">
        <button type="button" aria-expanded={choosing} onClick={() => setChoosing(!choosing)}>
          {words.plots.choose}
        </button>
        <button type="button" onClick={() => plot.current?.unzoom()}>
          {words.plots.reset}
        </button>
        <button type="button" onClick={() => choose([])} disabled={chosen.length === 0}>
          {words.plots.clear}
        </button>
        <button type="button" onClick={() => studio.dock?.addPlot()}>
          {words.plots.add}
        </button>
        {run ? null : <span className="quiet">{words.plots.noRun}</span>}
        {late.length ? <span className="quiet">{words.plots.late(late.join(', '))}</span> : null}
      </div>
      <div className="plot-place">
        {choosing && run ? <ChannelTree channels={run.channels} chosen={chosen} onChoose={choose} /> : null}
        <div className="plot-host" ref={host} />
      </div>
    </div>
  )
}

/** Names of chosen channels that a live run does not have: they follow from the recording of the whole run. */
function lateChannels(run: Run, chosen: readonly PlotColumn[]): readonly string[] {
  const names = [...new Set(chosen.map(one => one.channel))]
  return names.filter(name => !run.channels.some(one => one.name === name)).map(channelName)
}

/** What a new plot shows: how fast the tool moves and how far it is off its path, be that known at the end only. */
function firstColumns(run: Run | null, station: string): readonly PlotColumn[] {
  const isKnown = (channel: string) => run?.live || run?.channels.some(one => one.name === channel)
  const first = ['tcp_speed', 'path_error'].map(one => channelOf(one, station)).filter(isKnown)
  if (first.length) return first.map(channel => ({ channel, column: 0 }))
  const q = run?.channels.find(one => one.name === channelOf('q', station))
  return q ? q.columns.map((_, column) => ({ channel: q.name, column })) : []
}

function readColumns(kept: unknown): readonly PlotColumn[] | null {
  if (!Array.isArray(kept)) return null
  return kept.filter(
    (one: Partial<PlotColumn> | null): one is PlotColumn =>
      typeof one?.channel === 'string' && typeof one.column === 'number',
  )
}
