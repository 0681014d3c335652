/** The timeline at the bottom of the page. */
import { useEffect, useRef } from 'react'
import { Timeline } from '../run/timeline'
import { words } from '../text/messages'
import { useStudio, useStudioState } from './context'

export function TimelineBar() {
  const studio = useStudio()
  const host = useRef<HTMLDivElement>(null)
  const timeline = useRef<Timeline | null>(null)
  const shown = useStudioState(state => state.shown)
  const presses = useStudioState(state => state.presses)
  const lagging = useStudioState(
    state => state.live !== null && state.live.state !== 'over' && !state.following,
  )
  useEffect(() => {
    if (!host.current) return
    const made = new Timeline(host.current, studio.transport)
    timeline.current = made
    return () => made.destroy()
  }, [studio])
  useEffect(() => {
    // Presses of a live run are marked as they come.
    if (studio.run?.live && presses.length > 0) studio.transport.show(studio.run)
    if (shown >= 0) timeline.current?.show()
  }, [studio, shown, presses])
  return (
    <div className="timeline-bar">
      <div className="timeline-host" ref={host} />
      {lagging ? (
        <button type="button" onClick={() => studio.follow()}>
          {words.run.follow}
        </button>
      ) : null}
    </div>
  )
}
