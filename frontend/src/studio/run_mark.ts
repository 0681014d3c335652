/** What stands before the result of a run that is not the one of the chosen program and the texts as they are. */
import type { RunStation } from '../run/station'
import { resultWords as words } from '../text/result'
import { stationOf } from './document_names'
import type { StudioState } from './state'

type Shown = Pick<StudioState, 'ran' | 'program' | 'told'>

/** Name of the program whose run is shown where the chosen one took no part in it; else empty. */
export function ranInstead({ ran, program, told }: Shown, stations: readonly RunStation[]): string {
  if (told || ran === program || stationOf(stations, program) !== '') return ''
  return ran
}

/** In words, why the shown run is not the result that is wanted; empty where it is. */
export function runMark(
  state: Shown & Pick<StudioState, 'stale' | 'changed' | 'older'>,
  stations: readonly RunStation[],
): string {
  const ran = ranInstead(state, stations)
  const age = state.stale ? words.stale : state.older ? words.older : state.changed ? words.changed : ''
  if (ran === '') return age
  return age === '' ? words.runOf(ran) : words.markOf(age, ran)
}
