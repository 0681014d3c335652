/** What stands above the steps: how many are refused, being checked, or that all are accepted. */
import { taskWords } from '../../text/tasks'
import type { StepState } from '../../wire/messages'

export interface HeadlinePart {
  readonly tone: 'error' | 'quiet' | 'good'
  readonly text: string
}

/** `states` has one for each step, null for one of which nothing has been said yet. */
export function headline(states: readonly (StepState | null)[]): readonly HeadlinePart[] {
  const refused = states.filter(one => one?.accepted === false).length
  const waiting = states.filter(one => one === null).length
  if (refused + waiting === 0) return [{ tone: 'good', text: taskWords.allAccepted(states.length) }]
  return [
    ...(refused ? [{ tone: 'error', text: taskWords.refused(refused) } as const] : []),
    ...(waiting ? [{ tone: 'quiet', text: taskWords.beingChecked(waiting) } as const] : []),
  ]
}
