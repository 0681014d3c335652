/** One word on connection and run, at the top right. */
import { isBehind } from '../run/pace'
import { words } from '../text/messages'
import type { RunStatus } from '../wire/messages'
import { useStudioState } from './context'
import type { StudioState } from './state'

type Tone = 'good' | 'running' | 'warning' | 'error' | 'quiet'

export function runWords(state: StudioState): readonly [Tone, string] {
  const { connection, live, status } = state
  if (connection === 'lost' || connection === 'expired') return ['error', words.connection[connection]]
  if (connection === 'connecting') return ['quiet', words.connection.connecting]
  if (live && live.state !== 'over') {
    if (live.state === 'starting') return ['running', words.run.liveStarting]
    if (live.state === 'held') return ['running', words.run.liveHeld]
    if (isBehind(state.pace, live.speed)) return ['warning', words.run.liveBehind(state.pace, live.speed)]
    if (live.override < 1) return ['running', words.run.liveSlowed(Math.round(live.override * 100))]
    return ['running', `${words.run.live} ${live.speed}×`]
  }
  switch (status?.state) {
    case 'waiting':
    case 'running':
      return ['running', status.message || words.run[status.state]]
    case 'refused':
      return ['error', isOfCell(status) ? words.run.refusedCell : words.run.refused]
    case 'failed':
      return ['error', words.run.failedShort]
    case 'cancelled':
      return ['warning', words.run.cancelled]
    case 'done':
      // Done at the server; what it came to is still on its way to this page.
      if (state.shown === 0) return ['quiet', words.run.preparing]
      return state.problems.some(one => one.severity === 'error' && one.time !== null)
        ? ['warning', words.run.withErrors]
        : ['good', words.run.done]
    default:
      return ['quiet', words.run.none]
  }
}

/** Whether every error that stands in the way of a run is one of the cell file. */
function isOfCell(status: RunStatus): boolean {
  const errors = status.findings.filter(one => one.severity === 'error')
  return errors.length > 0 && errors.every(one => one.span?.source.endsWith('cell.toml'))
}

export function RunPill() {
  const tone = useStudioState(state => runWords(state)[0])
  const text = useStudioState(state => runWords(state)[1])
  return (
    <span className={`pill ${tone}`} role="status">
      <i aria-hidden="true" />
      {text}
    </span>
  )
}
