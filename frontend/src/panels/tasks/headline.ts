/** What stands above the steps: how many are refused, being checked, or that all are accepted. */
import { taskWords } from '../../text/tasks'
import type { StepState } from '../../wire/messages'

export interface HeadlinePart {
  readonly tone: 'error' | 'quiet' | 'good'
  readonly text: string
}

/** `states` has one for each step: null before its first answer, `unfilled` while its fields are not filled in yet. */
export function headline(states: readonly (StepState | 'unfilled' | null)[]): readonly HeadlinePart[] {
  const unfilled = states.filter(one => one === 'unfilled').length
  const refused = states.filter(one => one !== 'unfilled' && one?.accepted === false).length
  const waiting = states.filter(one => one === null).length
  if (refused + waiting + unfilled === 0)
    return [{ tone: 'good', text: taskWords.allAccepted(states.length) }]
  return [
    ...(refused ? [{ tone: 'error', text: taskWords.refused(refused) } as const] : []),
    ...(unfilled ? [{ tone: 'quiet', text: taskWords.incomplete(unfilled) } as const] : []),
    ...(waiting ? [{ tone: 'quiet', text: taskWords.beingChecked(waiting) } as const] : []),
  ]
}
