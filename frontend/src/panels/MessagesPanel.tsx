/** What the program has printed: time, line and text; a click goes there. A live run adds to it. */
import { useMemo } from 'react'
import type { RunEvent } from '../run/run'
import { useStudio, useStudioState } from '../studio/context'
import { fileName } from '../studio/document_names'
import { useTicks } from '../studio/hooks'
import { words } from '../text/messages'
import { formatQuantity } from '../units/quantity'
import { Scroll } from './Scroll'

/** So many rows are shown, the newest ones. */
const MOST = 1000

export function MessagesPanel() {
  const studio = useStudio()
  const shown = useStudioState(state => state.shown)
  useTicks(4)
  const run = shown > 0 ? studio.run : null
  const count = run?.events.length ?? 0
  // A live run grows by events; a finished one is another run.
  // biome-ignore lint/correctness/useExhaustiveDependencies: the events are the same array while they grow
  const messages = useMemo(() => run?.events.filter(one => one.kind === 'message') ?? [], [run, count])
  if (messages.length === 0) return <p className="empty">{run ? words.messages.none : words.run.none}</p>
  const left = messages.length - MOST
  return (
    <Scroll label={words.messages.region}>
      {left > 0 ? <p className="quiet">{words.messages.left(left)}</p> : null}
      <ul className="messages">
        {messages.slice(-MOST).map((one, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: messages are only ever appended
          <MessageRow key={at} message={one} />
        ))}
      </ul>
    </Scroll>
  )
}

function MessageRow({ message }: { message: RunEvent }) {
  const studio = useStudio()
  const { span, time, text } = message
  const place = span ? studio.lines.place(span.source, span.line) : null
  const several = (studio.run?.stations.length ?? 0) > 1
  const go = () => {
    studio.transport.go(time)
    if (span) studio.goToRun(span.source, span.line)
  }
  return (
    <li>
      <button type="button" className="message" onClick={go}>
        <span className="message-time">{formatQuantity(time, 's')}</span>
        <span className="message-line">
          {place ? words.messages.line(place.line, several ? fileName(place.document) : '') : ''}
        </span>
        <span className="message-text">{text}</span>
      </button>
    </li>
  )
}
