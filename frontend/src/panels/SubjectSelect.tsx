/** Which station or device a list shows; nothing where there is only one. */
import type { ChannelInfo } from '../run/run'
import { words } from '../text/messages'

interface SubjectSelectProps {
  readonly channels: readonly ChannelInfo[]
  /** Null for all. */
  readonly chosen: string | null
  readonly onChoose: (subject: string | null) => void
}

/** Value of the choice of all: no station is called so. */
const ALL = '*'

export function SubjectSelect({ channels, chosen, onChoose }: SubjectSelectProps) {
  const subjects = subjectsOf(channels)
  if (subjects.filter(Boolean).length < 2) return null
  return (
    <select
      aria-label={words.subjects.choose}
      value={chosen === null || !subjects.includes(chosen) ? ALL : chosen}
      onChange={event => onChoose(event.target.value === ALL ? null : event.target.value)}
    >
      <option value={ALL}>{words.subjects.all}</option>
      {subjects.map(one => (
        <option key={one} value={one}>
          {one || words.subjects.cell}
        </option>
      ))}
    </select>
  )
}

/** Stations and devices in the order of their channels; the empty name stands for the cell. */
export function subjectsOf(channels: readonly ChannelInfo[]): readonly string[] {
  return [...new Set(channels.map(one => one.subject))]
}

/** Channels of a station or device; all for null, and where nothing is called so. */
export function ofSubject(channels: readonly ChannelInfo[], chosen: string | null): readonly ChannelInfo[] {
  const own = chosen === null ? [] : channels.filter(one => one.subject === chosen)
  return own.length > 0 ? own : channels
}
