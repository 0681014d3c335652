/** Every finding of texts, cell and run in one list; a click leads to its place. */
import type { IDockviewPanelProps } from 'dockview-react'
import { useEffect, useState } from 'react'
import { useStudio, useStudioState } from '../studio/context'
import type { Problem } from '../studio/problems'
import { severityIcons, words } from './editor_words'
import { matching } from './problem_order'
import './editor.css'

export function ProblemsPanel({ api }: IDockviewPanelProps) {
  const problems = useStudioState(state => state.problems)
  const [query, setQuery] = useState('')
  const shown = matching(problems, query)
  useEffect(() => {
    api.setTitle(words.title(problems.length))
  }, [api, problems.length])
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
        <output>{words.problems(shown.length, problems.length)}</output>
      </div>
      {shown.length === 0 ? (
        <p className="problems-empty">{problems.length === 0 ? words.allWell : words.noMatch}</p>
      ) : (
        <ul>
          {shown.map((problem, at) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: equal findings have nothing else that tells them apart
            <ProblemRow key={at} problem={problem} />
          ))}
        </ul>
      )}
    </div>
  )
}

function ProblemRow({ problem }: { problem: Problem }) {
  const studio = useStudio()
  const { document, line, column, severity, code, message, hint, time } = problem
  const act = () => {
    if (document) studio.goTo(document, Math.max(line, 1), Math.max(column, 1))
    if (time !== null) studio.transport.go(time)
  }
  const place = [document, line > 0 ? words.at(line) : '', time === null ? '' : words.time(time)]
  return (
    <li>
      <button
        type="button"
        className={`problem ${severity}`}
        onClick={act}
        disabled={!document && time === null}
      >
        <span className="problem-severity">
          <span aria-hidden="true">{severityIcons[severity]}</span> {words.severities[severity]}
        </span>
        <span className="problem-text">
          {message}
          {hint ? <span className="problem-hint"> {hint}</span> : null}
        </span>
        <span className="problem-place">
          {code} {place.filter(Boolean).join(', ')}
        </span>
      </button>
    </li>
  )
}
