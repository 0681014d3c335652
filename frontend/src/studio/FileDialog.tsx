/** The dialogs of the File menu: which folder, which name, from which example. */
import { type FormEvent, useEffect, useId, useLayoutEffect, useRef, useState } from 'react'
import { fileWords } from '../text/files'
import { useStudio, useStudioState } from './context'
import { FolderList } from './FolderList'
import { OriginChoice } from './OriginChoice'
import type { DialogKind } from './state'
import type { ProjectOrigin } from './studio'

const words = fileWords.dialog

/** The example that new projects begin with where nothing else is chosen, as with `ropsim new`. */
const STARTER = 'first_cell'

export function FileDialog({ kind }: { kind: Exclude<DialogKind, 'endTasks'> }) {
  const studio = useStudio()
  const dialog = useRef<HTMLDialogElement>(null)
  const { folder, recent, examples } = studio.store.getState()
  const [typed, setTyped] = useState(kind === 'recent' ? (recent[0] ?? '') : '')
  const [origin, setOrigin] = useState<ProjectOrigin>({
    example: (examples.find(one => one.name === STARTER) ?? examples[0])?.name ?? '',
    robot: '',
  })
  const refusal = useStudioState(state => state.refusal)
  const hint = useId()
  const why = useId()
  const field = useRef<HTMLInputElement>(null)
  const place = useStudioState(state => state.folders?.place)
  useEffect(() => {
    dialog.current?.showModal()
    // The dialog gives the keyboard to what stands first, which may be a list.
    field.current?.focus()
  }, [])
  // Closed before it is taken away, the keyboard goes back to where it was.
  useLayoutEffect(() => {
    const shown = dialog.current
    return () => shown?.close()
  }, [])
  const close = () => dialog.current?.close()
  const act = (event: FormEvent) => {
    event.preventDefault()
    const text = typed.trim()
    if (!text) return
    if (kind === 'newProject') studio.newProject(isFullPath(text) ? text : `${beside}/${text}`, origin)
    else if (kind === 'newProgram') studio.newProgram(text)
    else if (kind === 'saveAs') studio.saveAs(text)
    else studio.openProject(text)
  }
  const isProject = kind === 'newProject' || kind === 'openProject' || kind === 'recent'
  const beside = place || folder.replace(/[/\\][^/\\]*$/, '') || '/'
  const label = kind === 'newProject' ? words.newFolder : isProject ? words.folder : words.name
  const help =
    kind === 'newProject' ? words.newFolderHint(beside) : isProject ? words.folderHint : words.nameHint
  return (
    <dialog
      ref={dialog}
      className="file-dialog"
      aria-label={words.titles[kind]}
      onClose={() => studio.store.setState({ dialog: null, refusal: null })}
    >
      <form onSubmit={act}>
        <h2>{words.titles[kind]}</h2>
        {kind === 'newProject' ? (
          <OriginChoice origin={origin} onOrigin={setOrigin} examples={examples} />
        ) : null}
        <label>
          {label}
          <input
            type="text"
            ref={field}
            required
            spellCheck={false}
            aria-describedby={refusal ? `${why} ${hint}` : hint}
            aria-invalid={refusal !== null}
            value={typed}
            onChange={event => {
              setTyped(event.target.value)
              studio.store.setState({ refusal: null })
            }}
          />
        </label>
        {refusal ? (
          <p className="mistake" role="alert" id={why}>
            {refusal.text}
            {refusal.hint ? ` – ${refusal.hint}` : ''}
          </p>
        ) : null}
        <p className="quiet" id={hint}>
          {help} {isProject ? words.kept : ''}
        </p>
        {(kind === 'openProject' || kind === 'recent') && recent.length > 0 ? (
          <fieldset>
            <legend>{words.recentList}</legend>
            {recent.map(one => (
              <button
                key={one}
                type="button"
                className="recent"
                onClick={() => {
                  setTyped(one)
                  studio.openProject(one)
                }}
              >
                {one}
              </button>
            ))}
          </fieldset>
        ) : null}
        {kind === 'newProject' || kind === 'openProject' ? (
          <FolderList
            onProject={(one, how) => {
              if (kind === 'newProject') return
              setTyped(one.path)
              if (how === 'open') studio.openProject(one.path)
            }}
          />
        ) : null}
        <div className="actions">
          {kind === 'openProject' && examples.length > 0 ? (
            <button
              type="button"
              className="other"
              onClick={() => studio.store.setState({ dialog: 'newProject', refusal: null })}
            >
              {words.fromExample}
            </button>
          ) : null}
          <button type="button" onClick={close}>
            {words.cancel}
          </button>
          <button type="submit" className="primary">
            {words.ok[kind]}
          </button>
        </div>
      </form>
    </dialog>
  )
}

/** What names a place of its own, not one in the folder that is shown. */
function isFullPath(text: string): boolean {
  return /^([/\\~]|[a-z]:)/i.test(text)
}
