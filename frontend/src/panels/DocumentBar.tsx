/** Which text is shown, whether it is saved, and whether it is the program that is simulated. */
import type { KeyboardEvent } from 'react'
import { useStudio, useStudioState } from '../studio/context'
import { programIn, stationOf } from '../studio/document_names'
import type { StudioDocument } from '../studio/documents'
import { ranInstead } from '../studio/run_mark'
import { words } from './editor_words'

/** With more texts than these a list takes the place of tabs. */
const MOST_TABS = 5

interface DocumentsProps {
  readonly documents: readonly StudioDocument[]
  readonly shown: StudioDocument | undefined
}

export function DocumentBar({ documents, shown }: DocumentsProps) {
  const studio = useStudio()
  const editing = useStudioState(state => state.editing)
  const stale = useStudioState(state => state.stale)
  const ran = useStudioState(state => ranInstead(state, studio.run?.stations ?? []))
  const other = useStudioState(state => {
    const own = programIn(state.document, state.programs)
    const ran = state.shown > 0 ? (studio.run?.stations ?? []) : []
    return own !== '' && own !== state.program && stationOf(ran, own) === ''
  })
  const Choice = documents.length > MOST_TABS ? DocumentList : DocumentTabs
  return (
    <div className="program-bar">
      <Choice documents={documents} shown={shown} />
      <ResultCounts />
      {other ? (
        <button type="button" title={words.simulateTitle} onClick={() => studio.commands.run('run.now')}>
          {words.simulate}
        </button>
      ) : null}
      {stale ? (
        <span className="program-stale" title={words.stale}>
          {ran ? words.staleOf(ran) : words.staleShort}
        </span>
      ) : null}
      <button
        type="button"
        title={words.saveTitle}
        disabled={!shown?.unsaved || !editing}
        onClick={() => shown && studio.save(shown.name)}
      >
        {words.save}
      </button>
    </div>
  )
}

/** How many lines have which result, for who does not see the marks beside them, and for all others. */
function ResultCounts() {
  const counts = useStudioState(state => state.counts)
  return counts && <span className="program-results quiet" role="status" {...counts} />
}

function DocumentList({ documents, shown }: DocumentsProps) {
  const studio = useStudio()
  const runBy = useRunBy()
  return (
    <select
      className="program-list"
      aria-label={words.documents}
      value={shown?.name ?? ''}
      onChange={event => studio.store.setState({ document: event.target.value })}
    >
      {documents.map(one => (
        <option key={one.name} value={one.name}>
          {one.unsaved ? `● ${shortName(one.name)}` : shortName(one.name)}
          {runBy(one.name) ? ` – ${runBy(one.name)}` : ''}
        </option>
      ))}
    </select>
  )
}

function DocumentTabs({ documents, shown }: DocumentsProps) {
  const studio = useStudio()
  const runBy = useRunBy()
  const show = (document: string) => studio.store.setState({ document })
  const step = (event: KeyboardEvent) => {
    const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0
    const at = documents.findIndex(one => one.name === shown?.name)
    const next = documents[(at + by + documents.length) % documents.length]
    if (by === 0 || !next) return
    event.preventDefault()
    show(next.name)
    const tabs = event.currentTarget.querySelectorAll<HTMLElement>('[role=tab]')
    tabs[documents.indexOf(next)]?.focus()
  }
  return (
    <div role="tablist" aria-label={words.documents} className="program-tabs" onKeyDown={step}>
      {documents.map(one => (
        <button
          key={one.name}
          type="button"
          role="tab"
          aria-selected={one === shown}
          tabIndex={one === shown ? 0 : -1}
          onClick={() => show(one.name)}
          title={one.name}
        >
          {shortName(one.name)}
          {runBy(one.name) ? (
            <span className="program-station" title={words.runBy(runBy(one.name))}>
              {runBy(one.name)}
            </span>
          ) : null}
          {one.unsaved ? (
            <span className="unsaved" role="img" aria-label={words.unsaved}>
              ●
            </span>
          ) : null}
        </button>
      ))}
    </div>
  )
}

/** Names of the stations that run the program of a document; empty for none, and where there is one station. */
function useRunBy(): (document: string) => string {
  const scene = useStudioState(state => state.scene)
  const programs = useStudioState(state => state.programs)
  const stations = scene?.stations ?? []
  return document => {
    const program = programIn(document, programs)
    if (program === '' || stations.length < 2) return ''
    const own = stations.filter(one => one.program === program)
    return own.map(one => one.name).join(', ')
  }
}

function shortName(name: string): string {
  return name.replace(/^programs\//, '')
}
