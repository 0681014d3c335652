/** Small bridges from the framework-free engines to components. */
import { useEffect, useReducer, useRef } from 'react'
import { onUnits } from '../units/choice'
import { useStudio } from './context'

/** Call `act` after changes of cursor, run or picture, at most `rate` times a second. */
export function useEvery(rate: number, act: () => void): void {
  const studio = useStudio()
  const newest = useRef(act)
  newest.current = act
  useEffect(() => studio.loop.every(rate, () => newest.current()), [studio, rate])
}

/** Draw the component again whenever a source says that it has changed. */
export function useChanges(source: { onChange(listener: () => void): () => void }): void {
  const [, again] = useReducer((count: number) => count + 1, 0)
  useEffect(() => source.onChange(again), [source])
}

/** Draw the component again at most `rate` times a second while things change. */
export function useTicks(rate: number): void {
  const [, again] = useReducer((count: number) => count + 1, 0)
  useEvery(rate, again)
}

/** Draw the component again when other units are chosen. */
export function useUnits(): void {
  useChanges(UNITS)
}

const UNITS = { onChange: onUnits }
