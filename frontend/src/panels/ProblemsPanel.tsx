/** Every finding of texts, cell and run in one list; a click leads to its place. */
import type { IDockviewPanelProps } from 'dockview-react'
import { useEffect, useState } from 'react'
import { useStudio, useStudioState } from '../studio/context'
import { belowCauses, grouped, nextOf, type ProblemGroup } from '../studio/problem_groups'
import { severityIcons, words } from './editor_words'
import { Marked } from './Marked'
import { matching } from './problem_order'
import './editor.css'

export function ProblemsPanel({ api }: IDockviewPanelProps) {
  const problems = useStudioState(state => state.problems)
  const [query, setQuery] = useState('')
  const found = matching(problems, query)
  const shown = belowCauses(grouped(found))
  // Each finding counts, as in the result and in the status line, also where some of them share a row.
  const all = problems.length
  useEffect(() => {
    api.setTitle(words.title(all))
  }, [api, all])
  return (
    <div className="problems">
      <div className="problems-bar">
        <input
          type="search"
          aria-label={words.filter}
          placeholder={words.filter}
          value={query}
          onChange={event => setQuery(event.target.value)}
        />
        <output>{words.problems(found.length, all)}</output>
      </div>
      {shown.length === 0 ? (
        <p className="problems-empty">{problems.length === 0 ? words.allWell : words.noMatch}</p>
      ) : (
        <ul>
          {shown.map((group, at) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: equal findings have nothing else that tells them apart
            <ProblemRow key={at} group={group} />
          ))}
        </ul>
      )}
    </div>
  )
}

function ProblemRow({ group }: { group: ProblemGroup }) {
  const studio = useStudio()
  const { document, file, line, severity, code, message, hint, time, follows } = group.first
  const count = group.all.length
  const act = () => {
    const chosen = nextOf(group, studio.cursor.time)
    const place = { document, line: Math.max(line, 1), column: Math.max(chosen.column, 1) }
    // Where bodies meet, the moment at which they are deepest in each other counts.
    if (chosen.time !== null) studio.goToFound(place, chosen.time, chosen.place ? 'moment' : 'pass')
    else if (document) studio.goTo(document, place.line, place.column)
    if (chosen.place) studio.picture.stage?.frame([...chosen.place])
  }
  const when = time === null ? '' : count > 1 ? words.firstTime(time) : words.time(time)
  const place = [document || file, line > 0 ? words.at(line) : '', when]
  return (
    <li>
      <button
        type="button"
        className={`problem ${severity}${follows ? ' follows' : ''}`}
        title={count > 1 ? words.countTitle : undefined}
        onClick={act}
        disabled={!document && time === null}
      >
        <span className="problem-severity">
          <span aria-hidden="true">{severityIcons[severity]}</span> {words.severities[severity]}
        </span>
        <span className="problem-text">
          <Marked text={message} />
          {count > 1 ? <strong className="problem-count">{words.count(count)}</strong> : null}
          {follows ? <em className="problem-cause">{words.follows(follows.line)}</em> : null}
          {hint ? (
            <span className="problem-hint">
              <Marked text={hint} />
            </span>
          ) : null}
        </span>
        <span className="problem-place">
          {code} {place.filter(Boolean).join(', ')}
        </span>
      </button>
    </li>
  )
}
