/** The texts of the project: tabs, editor, what stands between a text and its file. */
import { type ReactNode, useEffect, useRef, useState } from 'react'
import { useStudio, useStudioState } from '../studio/context'
import type { StudioDocument } from '../studio/documents'
import { DocumentBar } from './DocumentBar'
import { words } from './editor_words'
import { neighbour } from './problem_order'
import { useEditor } from './use_editor'
import './editor.css'

export function ProgramPanel() {
  const host = useRef<HTMLDivElement>(null)
  const loading = useEditor(host)
  const documents = useStudioState(state => state.documents)
  const name = useStudioState(state => state.document)
  const shown = documents.find(one => one.name === name)
  useProblemKeys()
  return (
    <div className="program">
      <DocumentBar documents={documents} shown={shown} />
      {shown ? <TextBanners shown={shown} /> : <p className="program-empty">{words.none}</p>}
      {loading === 'ready' ? null : (
        <p className="program-empty" role="status">
          {loading === 'loading' ? words.loading : words.failed(loading.failed)}
        </p>
      )}
      <div ref={host} className="program-text" id="program-text" />
    </div>
  )
}

function TextBanners({ shown }: { shown: StudioDocument }) {
  const studio = useStudio()
  const editing = useStudioState(state => state.editing)
  const [kept, setKept] = useState<readonly string[]>([])
  const { name } = shown
  return (
    <>
      {shown.conflict ? (
        <Banner level="warning" text={words.conflict}>
          <Choice text={words.reload} act={() => studio.revert(name)} isOff={!editing} />
          <Choice text={words.overwrite} act={() => studio.save(name, 'overwrite')} isOff={!editing} />
        </Banner>
      ) : null}
      {shown.recovered && !kept.includes(name) ? (
        <Banner level="info" text={words.recovered}>
          <Choice text={words.keep} act={() => setKept([...kept, name])} isOff={false} />
          <Choice text={words.discard} act={() => studio.revert(name)} isOff={!editing} />
        </Banner>
      ) : null}
      {editing ? null : <Banner level="info" text={words.readOnly} />}
    </>
  )
}

function Banner({
  level,
  text,
  children,
}: {
  level: 'warning' | 'info'
  text: string
  children?: ReactNode
}) {
  return (
    <div className={`program-banner ${level}`} role="status">
      <span>{text}</span>
      {children}
    </div>
  )
}

function Choice({ text, act, isOff }: { text: string; act: () => void; isOff: boolean }) {
  return (
    <button type="button" onClick={act} disabled={isOff}>
      {text}
    </button>
  )
}

/** F8 and Shift+F8 go from problem to problem through all texts. */
function useProblemKeys(): void {
  const studio = useStudio()
  useEffect(() => {
    let last = { document: '', line: 0, column: 0 }
    const stop = studio.onGoTo(place => {
      last = place
    })
    const go = (direction: 'next' | 'previous') => {
      const shown = studio.store.getState().document
      const from = last.document === shown ? last : { document: shown, line: 0, column: 0 }
      const found = neighbour(studio.problems, from, direction)
      if (found) studio.goTo(found.document, found.line, found.column)
    }
    const common = { menu: 'View', group: 'problems', enabled: () => studio.problems.length > 0 } as const
    const removals = [
      studio.commands.add({
        ...common,
        id: 'problems.next',
        title: words.next,
        keys: ['F8'],
        run: () => go('next'),
      }),
      studio.commands.add({
        ...common,
        id: 'problems.previous',
        title: words.previous,
        keys: ['Shift+F8'],
        run: () => go('previous'),
      }),
    ]
    return () => {
      stop()
      for (const remove of removals) remove()
    }
  }, [studio])
}
