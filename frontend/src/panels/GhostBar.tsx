/** The one bar of the ghost: which line and pass it shows; buttons lead through the passes, go there, hide it. */
import { useStudio, useStudioState } from '../studio/context'
import { words } from '../text/messages'

export function GhostBar() {
  const studio = useStudio()
  const ghost = useStudioState(state => state.ghost)
  if (!ghost) return null
  const { views } = words
  const { document, line, pass, passes, time } = ghost
  const step = (by: -1 | 1, name: string, sign: string) => (
    <button
      type="button"
      aria-label={name}
      title={name}
      disabled={pass + by < 1 || pass + by > passes}
      onClick={() => studio.showLine(document, line, pass + by)}
    >
      {sign}
    </button>
  )
  return (
    <fieldset className="badge ghost" aria-label={views.ghostBar}>
      <output>{views.ghost(line, pass, passes)}</output>
      {passes > 1 ? step(-1, views.previousPass, '‹') : null}
      {passes > 1 ? step(1, views.nextPass, '›') : null}
      <button type="button" onClick={() => studio.transport.go(time)}>
        {views.goThere}
      </button>
      <button type="button" aria-label={views.hide} title={views.hide} onClick={() => studio.clearGhost()}>
        ×
      </button>
    </fieldset>
  )
}
