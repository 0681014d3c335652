/** `End`: under which name the program is made; nothing is written over without being asked for. */
import { type FormEvent, useEffect, useId, useLayoutEffect, useRef, useState } from 'react'
import { createPortal } from 'react-dom'
import { useStudio, useStudioState } from '../../studio/context'
import { useChanges } from '../../studio/hooks'
import { taskWords } from '../../text/tasks'
import { cycleTime } from './cycle_time'

const words = taskWords.dialog

export function EndDialog() {
  const open = useStudioState(state => state.dialog === 'endTasks')
  // What stands in a panel looks as things in panels do.
  return open ? createPortal(<Dialog />, document.body) : null
}

function Dialog() {
  const studio = useStudio()
  const { tasks } = studio
  const dialog = useRef<HTMLDialogElement>(null)
  const documents = useStudioState(state => state.documents)
  const refusal = useStudioState(state => state.refusal)
  const [typed, setTyped] = useState('')
  const [replace, setReplace] = useState(false)
  const hint = useId()
  const why = useId()
  useChanges(tasks)
  useEffect(() => dialog.current?.showModal(), [])
  // Closed before it is taken away, the keyboard goes back to where it was.
  useLayoutEffect(() => {
    const shown = dialog.current
    return () => shown?.close()
  }, [])
  const name = typed.trim()
  const isThere = documents.some(one => one.name === `programs/${name}.task`)
  const { answer, estimate } = tasks
  const hasPoints = Boolean(answer?.listed)
  const refused = tasks.steps.filter(one => tasks.stateOf(one.key)?.accepted === false).length
  const act = (event: FormEvent) => {
    event.preventDefault()
    if (!name || (isThere && !replace)) return
    studio.makeProgram(name, isThere ? 'replace' : 'new')
  }
  return (
    <dialog
      ref={dialog}
      className="file-dialog"
      aria-label={words.title}
      onClose={() => studio.store.setState({ dialog: null, refusal: null })}
    >
      <form onSubmit={act}>
        <h2>{words.title}</h2>
        {refused > 0 ? <p className="mistake">{words.left(refused)}</p> : null}
        <label>
          {words.name}
          <input
            type="text"
            autoFocus
            required
            spellCheck={false}
            aria-describedby={refusal ? `${why} ${hint}` : hint}
            aria-invalid={refusal !== null}
            value={typed}
            onChange={event => {
              setTyped(event.target.value)
              setReplace(false)
              studio.store.setState({ refusal: null })
            }}
          />
        </label>
        {isThere ? (
          <label className="replace">
            <span className="mistake">{words.there(name)}</span>
            <span>
              <input type="checkbox" checked={replace} onChange={() => setReplace(!replace)} />{' '}
              {hasPoints ? words.replaceBoth(name) : words.replace}
            </span>
          </label>
        ) : null}
        {refusal ? (
          <p className="mistake" role="alert" id={why}>
            {refusal.text}
            {refusal.hint ? ` – ${refusal.hint}` : ''}
          </p>
        ) : null}
        <p className="quiet" id={hint}>
          {words.hint} {hasPoints ? words.pointsHint : null}
        </p>
        <p>
          {taskWords.time}: <strong>{cycleTime(answer, estimate)}</strong>
        </p>
        <div className="actions">
          <button type="button" onClick={() => dialog.current?.close()}>
            {words.cancel}
          </button>
          <button type="submit" className="primary" disabled={!name || (isThere && !replace)}>
            {words.make}
          </button>
        </div>
      </form>
    </dialog>
  )
}
