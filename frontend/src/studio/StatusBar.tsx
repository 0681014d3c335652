/** The line at the bottom: findings, the picture in words, units, kind of time. */
import { useState } from 'react'
import { words } from '../text/messages'
import { useStudio, useStudioState } from './context'
import { useEvery } from './hooks'
import { textTwin } from './text_twin'

export function StatusBar() {
  const studio = useStudio()
  const errors = useStudioState(state => state.problems.filter(one => one.severity === 'error').length)
  const warnings = useStudioState(state => state.problems.filter(one => one.severity === 'warning').length)
  const inputs = useStudioState(state => state.status?.inputs ?? 0)
  const scene = useStudioState(state => state.scene)
  const [twin, setTwin] = useState('')
  const [software, setSoftware] = useState(false)
  const [moving, setMoving] = useState(false)
  useEvery(1, () => {
    const { stage, poses } = studio.picture
    setSoftware(stage?.stats().software ?? false)
    setMoving(studio.cursor.playing || studio.store.getState().following)
    if (!scene) return
    const text = textTwin(scene, poses, studio.run, studio.cursor.time)
    setTwin(text)
    stage?.describe(text)
  })
  return (
    <section className="status" aria-label={words.status.bar}>
      <button
        type="button"
        className={errors ? 'error' : warnings ? 'warning' : ''}
        onClick={() => studio.dock?.show('problems')}
      >
        {words.status.problems(errors, warnings)}
      </button>
      {/* Spoken where the picture stands still: while it moves, the words would never end. */}
      <span className="twin" aria-live={moving ? 'off' : 'polite'}>
        {twin}
      </span>
      {inputs ? <span>{words.status.inputs(inputs)}</span> : null}
      {software ? <span title={words.status.softwareTitle}>{words.status.software}</span> : null}
      <span title={words.status.unitsTitle}>{words.status.units}</span>
      <span title={words.status.timeTitle}>{words.status.time}</span>
    </section>
  )
}
