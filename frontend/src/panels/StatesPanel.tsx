/** Every state of the run at the cursor: a number with its unit, and where it lies in its range. */
import { useMemo, useRef, useState } from 'react'
import { useStudio, useStudioState } from '../studio/context'
import { useEvery } from '../studio/hooks'
import { words } from '../text/messages'
import { formatPlain, formatQuantity } from '../units/quantity'
import { Scroll } from './Scroll'
import { ofSubject, SubjectSelect } from './SubjectSelect'
import { filterRows, type StateRow, share, stateRows } from './state_rows'

interface Cells {
  readonly value: HTMLElement | null
  readonly bar: HTMLElement | null
}

export function StatesPanel() {
  const studio = useStudio()
  const shown = useStudioState(state => state.shown)
  const scene = useStudioState(state => state.scene)
  const [group, setGroup] = useState('')
  const [query, setQuery] = useState('')
  const run = shown > 0 ? studio.run : null
  const [subject, setSubject] = useState<string | null>(null)
  const rows = useMemo(
    () => (run ? stateRows(ofSubject(run.channels, subject), scene?.stations ?? []) : []),
    [run, scene, subject],
  )
  const groups = useMemo(() => [...new Set(rows.map(row => row.group))], [rows])
  const visible = useMemo(() => filterRows(rows, group, query), [rows, group, query])
  const cells = useRef(new Map<string, Cells>())
  useEvery(10, () => {
    const time = studio.cursor.time
    for (const row of visible) {
      const value = run?.value(row.channel, row.column, time) ?? Number.NaN
      const jogged = row.subject === studio.jog.station ? studio.jog.q?.[row.joint] : undefined
      write(cells.current.get(row.key), row, value, jogged)
    }
  })
  if (!run) return <p className="empty">{words.states.none}</p>
  return (
    <>
      <div className="toolbar">
        <input
          type="search"
          aria-label={words.states.filter}
          placeholder={words.states.filter}
          value={query}
          onChange={event => setQuery(event.target.value)}
        />
        <SubjectSelect channels={run.channels} chosen={subject} onChoose={setSubject} />
        <select
          aria-label={words.states.group}
          value={group}
          onChange={event => setGroup(event.target.value)}
        >
          <option value="">{words.states.all}</option>
          {groups.map(one => (
            <option key={one} value={one}>
              {groupName(one)}
            </option>
          ))}
        </select>
      </div>
      <Scroll label={words.states.region} className="states-place">
        <table className="states" aria-label={words.states.table}>
          <thead>
            <tr>
              <th scope="col">{words.states.quantity}</th>
              <th scope="col" className="number">
                {words.states.value}
              </th>
              <th scope="col">{words.states.range}</th>
            </tr>
          </thead>
          <tbody>
            {visible.map(row => (
              <Row
                key={row.key}
                row={row}
                value={run.value(row.channel, row.column, studio.cursor.time)}
                keep={found => {
                  if (found) cells.current.set(row.key, found)
                  else cells.current.delete(row.key)
                }}
              />
            ))}
          </tbody>
        </table>
        {visible.length === 0 ? <p className="empty">{words.states.nothing}</p> : null}
      </Scroll>
    </>
  )
}

interface RowProps {
  readonly row: StateRow
  readonly value: number
  readonly keep: (cells: Cells | null) => void
}

function Row({ row, value, keep }: RowProps) {
  const studio = useStudio()
  const jog = (element: HTMLInputElement) => {
    if (!studio.jog.q || studio.jog.station !== row.subject) studio.jogFromRun(row.subject)
    studio.jog.moveJoint(row.joint, Number(element.value))
  }
  return (
    <tr
      ref={line => {
        keep(line ? { value: line.querySelector('.number'), bar: line.querySelector('.bar i, input') } : null)
      }}
    >
      <th scope="row" title={`${row.symbol} · ${row.description}`}>
        {row.name}
      </th>
      <td className="number">{format(row, value)}</td>
      <td>
        {row.joint >= 0 && Number.isFinite(row.min) ? (
          <input
            type="range"
            aria-label={words.states.jog(row.jointName)}
            min={row.min}
            max={row.max}
            step="any"
            defaultValue={value}
            onInput={event => jog(event.currentTarget)}
            onPointerUp={() => studio.jog.commit(words.jog.moveJoint(row.jointName))}
            onKeyUp={() => studio.jog.commit(words.jog.moveJoint(row.jointName))}
          />
        ) : (
          <div className="bar" aria-hidden="true">
            <i />
          </div>
        )}
      </td>
    </tr>
  )
}

function write(cells: Cells | undefined, row: StateRow, value: number, jogged: number | undefined): void {
  if (!cells) return
  const text = format(row, value)
  if (cells.value && cells.value.textContent !== text) cells.value.textContent = text
  const { bar } = cells
  if (bar instanceof HTMLInputElement) {
    if (bar !== document.activeElement || jogged === undefined) bar.value = String(jogged ?? value)
    bar.setAttribute('aria-valuetext', formatQuantity(Number(bar.value), row.unit))
  } else if (bar) {
    bar.style.transform = `scaleX(${share(value, row.min, row.max).toFixed(4)})`
  }
}

function format(row: StateRow, value: number): string {
  return row.unit ? formatQuantity(value, row.unit) : formatPlain(value)
}

export function groupName(group: string): string {
  return (words.states.groups as Readonly<Record<string, string>>)[group] ?? group
}
