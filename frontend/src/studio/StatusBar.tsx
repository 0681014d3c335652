/** The line at the bottom: findings, the picture in words, units, kind of time. */
import { useRef, useState } from 'react'
import { words } from '../text/messages'
import { shownUnit } from '../units/quantity'
import { useStudio, useStudioState } from './context'
import { useEvery, useUnits } from './hooks'
import { textTwin } from './text_twin'

export function StatusBar() {
  const studio = useStudio()
  const errors = useStudioState(state => state.problems.filter(one => one.severity === 'error').length)
  const warnings = useStudioState(state => state.problems.filter(one => one.severity === 'warning').length)
  useUnits()
  const inputs = useStudioState(state => state.status?.inputs ?? 0)
  const scene = useStudioState(state => state.scene)
  const [spoken, setSpoken] = useState('')
  const shown = useRef<HTMLSpanElement>(null)
  const [software, setSoftware] = useState(false)
  const [moving, setMoving] = useState(false)
  const jogged = () => {
    const { answer, station, q } = studio.jog
    return answer && q ? { station, q: answer.q, tcp: answer.tcp } : null
  }
  const twin = () =>
    scene ? textTwin(scene, studio.picture.poses, studio.run, studio.cursor.time, jogged()) : ''
  // Read by eye ten times a second; told to those who listen at most once.
  useEvery(10, () => {
    if (shown.current) shown.current.textContent = twin()
  })
  useEvery(1, () => {
    const { stage } = studio.picture
    setSoftware(stage?.stats().software ?? false)
    setMoving(studio.cursor.playing || studio.store.getState().following)
    const text = twin()
    setSpoken(text)
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
      <span className="twin" ref={shown} aria-hidden="true" />
      {/* Spoken where the picture stands still: while it moves, the words would never end. */}
      <span className="unseen" aria-live={moving ? 'off' : 'polite'}>
        {spoken}
      </span>
      {inputs ? <span>{words.status.inputs(inputs)}</span> : null}
      {software ? <span title={words.status.softwareTitle}>{words.status.software}</span> : null}
      <span title={words.status.unitsTitle}>
        {words.status.units(shownUnit('m').unit, shownUnit('rad').unit)}
      </span>
      <span title={words.status.timeTitle}>{words.status.time}</span>
    </section>
  )
}
