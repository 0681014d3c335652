/** The timeline at the bottom of the page. */
import { useEffect, useRef } from 'react'
import { Timeline } from '../run/timeline'
import { words } from '../text/messages'
import { useStudio, useStudioState } from './context'
import { useEvery } from './hooks'

export function TimelineBar() {
  const studio = useStudio()
  const host = useRef<HTMLDivElement>(null)
  const shown = useStudioState(state => state.shown + state.looked)
  const live = useStudioState(state => state.live)
  const lagging = useStudioState(
    state => state.live !== null && state.live.state !== 'over' && !state.following,
  )
  useEffect(() => {
    if (!host.current) return
    const made = new Timeline(host.current, studio.transport, 'always')
    studio.timeline = made
    return () => {
      studio.timeline = null
      made.destroy()
    }
  }, [studio])
  useEffect(() => {
    // Another run, or play and pause have another meaning.
    if (shown >= 0 || live) studio.timeline?.show()
  }, [studio, shown, live])
  useEvery(2, () => {
    // Signals and presses of a live run are marked as they come.
    if (!studio.run?.live) return
    studio.transport.show(studio.run)
    studio.timeline?.show()
  })
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
