/** The results of the lines of a document, in components. */
import { useMemo } from 'react'
import { useStudioState } from '../studio/context'
import { type LineResults, lineResults } from '../studio/line_results'

const NO_LINES = [] as const

export function useLineResults(document: string): LineResults {
  const lines = useStudioState(state => state.lines[document]) ?? NO_LINES
  const known = useStudioState(state => state.results[document])
  const coming = useStudioState(({ status, changed }) =>
    changed || status?.state === 'waiting' || status?.state === 'running' ? 'run' : 'nothing',
  )
  return useMemo(() => lineResults(lines, known, coming), [lines, known, coming])
}
