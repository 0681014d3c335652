/** The 3-D views and their settings. */
import { useEffect, useRef, useState } from 'react'
import type { StageState } from '../scene/settings'
import { Stage } from '../scene/stage'
import { useStudio, useStudioState } from '../studio/context'
import { ranInstead } from '../studio/run_mark'
import { isDark, onScheme } from '../style/scheme'
import { words } from '../text/messages'
import { GhostBar } from './GhostBar'
import { LookBar } from './LookBar'

export function ViewsPanel() {
  const studio = useStudio()
  const host = useRef<HTMLDivElement>(null)
  const [problems, setProblems] = useState<readonly string[]>([])
  const known = useStudioState(state => state.sceneKnown)
  const scene = useStudioState(state => state.scene)
  useEffect(() => {
    if (!host.current) return
    const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)').matches
    const stage = new Stage(host.current, { reducedMotion, theme: isDark() ? 'dark' : 'light' })
    const scheme = onScheme(() => stage.setTheme(isDark() ? 'dark' : 'light'))
    // Before the stage is given a scene: what that lacks is told at once.
    const told = stage.onProblems(() =>
      setProblems(stage.problems.map(one => [one.body, one.file, one.reason].filter(Boolean).join(': '))),
    )
    studio.picture.attach(stage)
    stage.select(studio.store.getState().selected)
    const cameras = studio.storage.read('cameras')
    if (isStageState(cameras)) stage.restore({ ...cameras, layout: studio.store.getState().look.layout })
    const keep = stage.onViewChange(() => studio.storage.write('cameras', stage.state()))
    const pick = stage.onPick(body => studio.select(body < 0 ? null : body))
    const drawn = stage.onDrawn(() => {
      if (studio.store.getState().scene) document.body.dataset.ready = ''
    })
    studio.loop.mark()
    return () => {
      for (const stop of [scheme, keep, pick, told, drawn]) stop()
      studio.picture.detach()
      stage.dispose()
    }
  }, [studio])
  useEffect(() => {
    // Without 3-D the page is ready as soon as it knows the cell.
    if (known && (!scene || !Stage.supported())) document.body.dataset.ready = ''
  }, [known, scene])
  return (
    <>
      <LookBar />
      <div className="stage-place">
        <div className="stage-host" ref={host} />
        {scene ? null : <p className="stage-words">{known ? words.views.broken : words.views.waiting}</p>}
        <StageBadges />
        {problems.length ? (
          <details className="stage-problems">
            <summary>
              {words.views.problems}: {problems.length}
            </summary>
            <ul>
              {problems.map(one => (
                <li key={one}>{one}</li>
              ))}
            </ul>
          </details>
        ) : null}
      </div>
    </>
  )
}

/** Over the picture: that it is old or of another program, what its ghost shows. */
function StageBadges() {
  const studio = useStudio()
  const stale = useStudioState(state => state.stale)
  const older = useStudioState(state => state.older && !state.stale)
  const ran = useStudioState(state => ranInstead(state, studio.run?.stations ?? []))
  const broken = useStudioState(state => state.scene !== null && state.cellBroken)
  return (
    <div className="stage-badges">
      {stale ? <span className="badge warning">{ran ? words.run.staleOf(ran) : words.run.stale}</span> : null}
      {ran && !stale ? <span className="badge warning">{words.run.runOf(ran)}</span> : null}
      {older ? <span className="badge warning">{words.run.older}</span> : null}
      {broken ? <span className="badge error">{words.views.oldCell}</span> : null}
      <GhostBar />
    </div>
  )
}

function isStageState(kept: unknown): kept is StageState {
  return typeof kept === 'object' && kept !== null && Array.isArray((kept as Partial<StageState>).views)
}
