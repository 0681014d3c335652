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
  const stale = useStudioState(state => state.stale)
  const lagging = useStudioState(
    state => state.live !== null && state.live.state !== 'over' && !state.following,
  )
  useEffect(() => {
    if (!host.current) return
    const made = new Timeline(host.current, studio.cursor)
    timeline.current = made
    return () => made.destroy()
  }, [studio])
  useEffect(() => {
    if (shown >= 0) timeline.current?.show(studio.run)
  }, [studio, shown])
  return (
    <div className="timeline-bar">
      <div className="timeline-host" ref={host} />
      {lagging ? (
        <button type="button" onClick={() => studio.follow()}>
          {words.run.follow}
        </button>
      ) : null}
      {stale ? <span className="badge warning">{words.run.stale}</span> : null}
    </div>
  )
}
