/** The command line: a line is carried out at once by the simulated robot; answers and findings stand below it. */
import type { IDockviewPanelProps } from 'dockview-react'
import { type KeyboardEvent, useEffect, useRef } from 'react'
import type { Finding } from '../run/run'
import { useStudio, useStudioState } from '../studio/context'
import { useChanges } from '../studio/hooks'
import { commandLineWords as words } from '../text/command_line'
import type { ToldLine } from '../wire/messages'
import { words as severityWords } from './editor_words'
import { Marked } from './Marked'
import './command.css'

const KEPT = 'commands'
const LIST = 'command-words'

export function CommandPanel({ api }: IDockviewPanelProps) {
  const studio = useStudio()
  const { commandLine } = studio
  useChanges(commandLine)
  const end = useRef<HTMLDivElement>(null)
  // The robot is started by who looks at the panel; one that stands behind others is made with the page.
  useEffect(() => {
    const open = () => {
      if (api.isVisible) commandLine.open(studio.storage.read(KEPT))
    }
    const frame = requestAnimationFrame(open)
    const seen = api.onDidVisibilityChange(open)
    return () => {
      cancelAnimationFrame(frame)
      seen.dispose()
    }
  }, [api, commandLine, studio])
  const { lines } = commandLine
  // biome-ignore lint/correctness/useExhaustiveDependencies: what comes last is to be seen
  useEffect(() => {
    end.current?.scrollIntoView({ block: 'nearest' })
  }, [lines, commandLine.busy])
  return (
    <div className="command-line">
      <CommandBar />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must take the keyboard */}
      <div className="scroll command-log" role="log" aria-label={words.log} tabIndex={0}>
        {lines.map((line, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: lines are only ever appended
          <Told key={at} told={line} />
        ))}
        {commandLine.busy ? <p className="quiet">{words.busy}</p> : null}
        <div ref={end} />
      </div>
      <CommandInput />
    </div>
  )
}

function CommandBar() {
  const studio = useStudio()
  const { commandLine } = studio
  const isShown = useStudioState(state => state.told)
  const finished = useStudioState(state => state.finished)
  const free = useFree() === ''
  return (
    <div className="toolbar">
      <button
        type="button"
        title={words.undoTitle}
        disabled={!free || commandLine.commands === 0}
        onClick={() => commandLine.tell('undo')}
      >
        {words.undo}
      </button>
      <button
        type="button"
        title={words.restartTitle}
        disabled={!free || commandLine.commands === 0}
        onClick={() => commandLine.tell('restart')}
      >
        {words.restart}
      </button>
      <button
        type="button"
        title={words.saveTitle}
        disabled={!free || commandLine.commands === 0}
        onClick={() => {
          commandLine.type('save ')
          document.getElementById('command-typed')?.focus()
        }}
      >
        {words.save}
      </button>
      {commandLine.busy ? (
        <button type="button" title={words.giveUpTitle} onClick={() => commandLine.giveUp()}>
          {words.giveUp}
        </button>
      ) : null}
      {isShown && finished > 0 ? (
        <button type="button" title={words.backTitle} onClick={() => studio.showProgramRun()}>
          {words.back}
        </button>
      ) : null}
      <span className="quiet">{words.count(commandLine.commands)}</span>
    </div>
  )
}

/** Why nothing can be told now; empty where it can. */
function useFree(): string {
  const isLive = useStudioState(state => state.live !== null && state.live.state !== 'over')
  const lost = useStudioState(state => state.connection !== 'connected')
  return lost ? words.lost : isLive ? words.live : ''
}

function CommandInput() {
  const { commandLine } = useStudio()
  const { block, chosen, offered } = commandLine
  const why = useFree()
  const key = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.nativeEvent.isComposing) return
    const acts: Readonly<Record<string, () => unknown>> = {
      Enter: () => commandLine.enter(),
      ArrowUp: () => commandLine.up(),
      ArrowDown: () => commandLine.down(),
      Escape: () => commandLine.escape(),
      // On an empty line the key leaves the field, as everywhere.
      Tab: () => !event.shiftKey && commandLine.complete(),
    }
    const act = acts[event.key]
    if (act && act() !== false) event.preventDefault()
  }
  return (
    <div className="command-input">
      {block ? <pre className="command-block">{prompted(block)}</pre> : null}
      {offered.length > 0 ? (
        <div id={LIST} className="command-words" role="listbox" aria-label={words.words} tabIndex={-1}>
          {offered.map((word, at) => (
            // biome-ignore lint/a11y/useKeyWithClickEvents: the field below has the keys
            <div
              key={word}
              id={`${LIST}-${at}`}
              role="option"
              tabIndex={-1}
              aria-selected={at === chosen}
              onClick={() => commandLine.take(word)}
            >
              {word}
            </div>
          ))}
        </div>
      ) : null}
      {why ? <p className="quiet">{why}</p> : null}
      <div className="command-row">
        <span aria-hidden="true">{block ? words.more : words.prompt}</span>
        <input
          id="command-typed"
          type="text"
          role="combobox"
          data-first=""
          aria-label={words.input}
          aria-expanded={offered.length > 0}
          aria-controls={LIST}
          aria-autocomplete="list"
          aria-activedescendant={chosen < 0 ? undefined : `${LIST}-${chosen}`}
          autoCapitalize="off"
          autoComplete="off"
          spellCheck={false}
          maxLength={4000}
          disabled={why !== ''}
          placeholder={block ? words.placeholderMore : words.placeholder}
          value={commandLine.typed}
          onChange={event => commandLine.type(event.target.value)}
          onKeyDown={key}
        />
      </div>
    </div>
  )
}

function prompted(lines: string): string {
  return lines
    .split('\n')
    .map((line, at) => `${at === 0 ? words.prompt : words.more} ${line}`)
    .join('\n')
}

function Told({ told }: { told: ToldLine }) {
  const { line, outcome, findings, first } = told
  const typed = line ? line.split('\n') : []
  const at = (finding: Finding) =>
    finding.span?.source === 'session'
      ? Math.min(Math.max(finding.span.line - first, 0), typed.length - 1)
      : -1
  return (
    <div className={`told ${outcome}`}>
      {typed.map((text, number) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the lines of a command stay as they are
        <div key={number}>
          <pre className="told-line">
            <span aria-hidden="true">{number === 0 ? words.prompt : words.more} </span>
            {text}
          </pre>
          {findings.filter(one => at(one) === number).map(Below)}
        </div>
      ))}
      {findings.filter(one => at(one) < 0).map(Below)}
      {told.told.map((text, number) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the answer stays as it is
        <p key={number} className="told-answer">
          {outcome === 'refused' ? <Marked text={text} /> : text}
        </p>
      ))}
    </div>
  )
}

/** A finding below the line that it is about, with a mark below the place. */
function Below({ span, severity, code, message, hint }: Finding, at: number) {
  const isHere = span?.source === 'session'
  const width = span && span.end_line === span.line ? Math.max(span.end_column - span.column, 1) : 1
  return (
    <div key={at} className={`told-finding ${severity}`}>
      {isHere ? <pre aria-hidden="true">{`${' '.repeat(span.column + 1)}${'^'.repeat(width)}`}</pre> : null}
      <p>
        <strong>{severityWords.severities[severity]}</strong> {code ? `${code}: ` : ''}
        <Marked text={message} />
        {hint ? (
          <span className="told-hint">
            {' '}
            <Marked text={hint} />
          </span>
        ) : null}
      </p>
      {span && !isHere ? <Elsewhere source={span.source} line={span.line} /> : null}
    </div>
  )
}

/** A place in a text of the project; a click goes there. */
function Elsewhere({ source, line }: { source: string; line: number }) {
  const studio = useStudio()
  const document = studio.documentOf(source)
  if (!document) return null
  return (
    <button type="button" onClick={() => studio.goTo(document, line)}>
      {words.place(document, line)}
    </button>
  )
}
