/** All channels in groups, with boxes to tick and a field to search. */
import { useState } from 'react'
import type { PlotColumn } from '../plot/plot'
import { unitOf } from '../run/column_units'
import type { ChannelInfo } from '../run/run'
import { words } from '../text/messages'
import { channelName, columnLabel, columnName, partsOf, quantityName } from '../units/names'
import { shownUnit } from '../units/quantity'
import { groupName } from './StatesPanel'
import { ofSubject, SubjectSelect, subjectsOf } from './SubjectSelect'

interface ChannelTreeProps {
  readonly channels: readonly ChannelInfo[]
  readonly chosen: readonly PlotColumn[]
  readonly onChoose: (columns: readonly PlotColumn[]) => void
}

export function ChannelTree({ channels, chosen, onChoose }: ChannelTreeProps) {
  const [query, setQuery] = useState('')
  const parts = query.toLowerCase().split(/\s+/).filter(Boolean)
  const [subject, setSubject] = useState<string | null>(null)
  const found = ofSubject(channels, subject).filter(one =>
    parts.every(part =>
      `${channelName(one.name)} ${one.name} ${one.description}`.toLowerCase().includes(part),
    ),
  )
  const several = subjectsOf(channels).filter(Boolean).length > 1
  const groups = groupsOf(found, several)
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
      <SubjectSelect channels={channels} chosen={subject} onChoose={setSubject} />
      <p className="quiet" role="status">
        {words.plots.found(found.length)}
      </p>
      {groups.map(group => (
        <fieldset key={group.name}>
          <legend>{group.name}</legend>
          {group.channels.map(channel => {
            const all = channel.columns.map((_, column) => column)
            const units = all.map(column => shownUnit(unitOf(channel, column)).unit)
            const unit = [...new Set(units)].join(' | ')
            return (
              <div key={channel.name} className="channel" title={`${channel.name} · ${channel.description}`}>
                <label>
                  <input
                    type="checkbox"
                    checked={all.every(column => isChosen(channel.name, column))}
                    onChange={event => set(channel.name, all, event.target.checked)}
                  />
                  {quantityName(partsOf(channel.name).quantity)}{' '}
                  {unit ? <span className="quiet">[{unit}]</span> : null}
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

interface Group {
  readonly name: string
  readonly channels: readonly ChannelInfo[]
}

/** Channels by their group, where there are several stations and devices by these first. */
function groupsOf(channels: readonly ChannelInfo[], several: boolean): readonly Group[] {
  const groups = new Map<string, ChannelInfo[]>()
  const subjects = several ? subjectsOf(channels) : [null]
  for (const subject of subjects) {
    for (const channel of channels) {
      if (subject !== null && channel.subject !== subject) continue
      const own = groupName(channel.group)
      const name = subject ? words.subjects.group(subject, own) : own
      groups.set(name, [...(groups.get(name) ?? []), channel])
    }
  }
  return [...groups].map(([name, own]) => ({ name, channels: own }))
}
