/** All channels in groups, with boxes to tick and a field to search. */
import { useState } from 'react'
import type { PlotColumn } from '../plot/plot'
import type { ChannelInfo } from '../run/run'
import { words } from '../text/messages'
import { channelName, columnLabel, columnName } from '../units/names'
import { shownUnit } from '../units/quantity'
import { groupName } from './StatesPanel'

interface ChannelTreeProps {
  readonly channels: readonly ChannelInfo[]
  readonly chosen: readonly PlotColumn[]
  readonly onChoose: (columns: readonly PlotColumn[]) => void
}

export function ChannelTree({ channels, chosen, onChoose }: ChannelTreeProps) {
  const [query, setQuery] = useState('')
  const parts = query.toLowerCase().split(/\s+/).filter(Boolean)
  const found = channels.filter(one =>
    parts.every(part =>
      `${channelName(one.name)} ${one.name} ${one.description}`.toLowerCase().includes(part),
    ),
  )
  const groups = [...new Set(found.map(one => one.group))]
  const isChosen = (channel: string, column: number) =>
    chosen.some(one => one.channel === channel && one.column === column)
  const set = (channel: string, columns: readonly number[], on: boolean) => {
    const others = chosen.filter(one => one.channel !== channel || !columns.includes(one.column))
    onChoose(on ? [...others, ...columns.map(column => ({ channel, column }))] : others)
  }
  return (
    <div className="channel-tree">
      <input
        type="search"
        aria-label={words.plots.search}
        placeholder={words.plots.search}
        value={query}
        onChange={event => setQuery(event.target.value)}
      />
      <p className="quiet" role="status">
        {words.plots.found(found.length)}
      </p>
      {groups.map(group => (
        <fieldset key={group}>
          <legend>{groupName(group)}</legend>
          {found
            .filter(one => one.group === group)
            .map(channel => {
              const all = channel.columns.map((_, column) => column)
              const unit = shownUnit(channel.unit).unit
              return (
                <div
                  key={channel.name}
                  className="channel"
                  title={`${channel.name} · ${channel.description}`}
                >
                  <label>
                    <input
                      type="checkbox"
                      checked={all.every(column => isChosen(channel.name, column))}
                      onChange={event => set(channel.name, all, event.target.checked)}
                    />
                    {channelName(channel.name)} {unit ? <span className="quiet">[{unit}]</span> : null}
                  </label>
                  {all.length > 1 ? (
                    <div className="columns">
                      {channel.columns.map((name, column) => (
                        <label key={name}>
                          <input
                            type="checkbox"
                            aria-label={columnName(channel.name, name)}
                            checked={isChosen(channel.name, column)}
                            onChange={event => set(channel.name, [column], event.target.checked)}
                          />
                          {columnLabel(channel.name, name)}
                        </label>
                      ))}
                    </div>
                  ) : null}
                </div>
              )
            })}
        </fieldset>
      ))}
    </div>
  )
}
