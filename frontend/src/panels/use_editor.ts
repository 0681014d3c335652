/** The editor engine in a component: loaded when first needed, fed from the studio. */
import { type RefObject, useEffect, useRef, useState } from 'react'
import type { ProgramEditor } from '../editor/program_editor'
import { useStudio, useStudioState } from '../studio/context'
import type { LineContent } from '../studio/line_contents'
import type { Place, Studio } from '../studio/studio'

export type Loading = 'loading' | 'ready' | { readonly failed: string }

/** Put an editor into `host`; it follows the documents, marks and rights of the studio. */
export function useEditor(host: RefObject<HTMLDivElement | null>): Loading {
  const studio = useStudio()
  const [editor, setEditor] = useState<ProgramEditor | null>(null)
  const [loading, setLoading] = useState<Loading>('loading')
  useEffect(() => {
    let made: ProgramEditor | null = null
    let isGone = false
    import('../editor/program_editor').then(
      module => {
        if (isGone || !host.current) return
        made = new module.ProgramEditor(host.current, optionsOf(studio))
        setEditor(made)
        setLoading('ready')
      },
      (reason: unknown) => setLoading({ failed: reason instanceof Error ? reason.message : String(reason) }),
    )
    return () => {
      isGone = true
      made?.destroy()
      setEditor(null)
    }
  }, [studio, host])
  useDocuments(editor)
  useMarks(editor)
  useWrap(editor)
  return loading
}

function optionsOf(studio: Studio) {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws'
  return {
    server: `${scheme}://${location.host}/ws/lsp`,
    taken: () => studio.commands.keysOverText,
    onChange: (document: string, text: string) => studio.edit(document, text),
    onLine: (document: string, line: number) => studio.showLine(document, line),
    onProblems: (...checked: Parameters<Studio['setChecked']>) => studio.setChecked(...checked),
    onLines: (document: string, lines: readonly LineContent[]) =>
      studio.store.setState(state => ({ lines: { ...state.lines, [document]: lines } })),
    onShow: (document: string) => studio.store.setState({ document }),
    onWrite: (document: string, change: (text: string) => string) =>
      studio.write(document, change(studio.text(document))),
  }
}

function useDocuments(editor: ProgramEditor | null): void {
  const studio = useStudio()
  const editing = useStudioState(state => state.editing)
  const wanted = useRef<Place | null>(null)
  // At once, not when React draws: a key that is pressed in between must find the text that is there.
  useEffect(() => {
    if (!editor) return
    const show = () => {
      const { documents, document } = studio.store.getState()
      const shown = documents.find(one => one.name === document)
      if (!shown) return
      editor.keep(documents.map(one => ({ ...one, text: studio.text(one.name) })))
      editor.open({ ...shown, text: studio.text(document) })
      goToWanted(editor, wanted)
    }
    show()
    return studio.store.subscribe((now, before) => {
      if (now.documents !== before.documents || now.document !== before.document) show()
    })
  }, [studio, editor])
  useEffect(
    () => (editor ? studio.desk.onTeach((text, taken) => editor.teach(text, taken)) : undefined),
    [studio, editor],
  )
  useEffect(() => (editor ? studio.desk.onAct(entry => editor.act(entry)) : undefined), [studio, editor])
  useEffect(() => editor?.setReadOnly(editing ? 'write' : 'read'), [editor, editing])
  useEffect(
    () =>
      studio.onGoTo(place => {
        wanted.current = place
        if (editor) goToWanted(editor, wanted)
      }),
    [studio, editor],
  )
}

/** Go where the studio asked to; a place in another document waits until that is shown. */
function goToWanted(editor: ProgramEditor, wanted: RefObject<Place | null>): void {
  const place = wanted.current
  if (place?.document !== editor.document) return
  wanted.current = null
  editor.goTo(place.line, place.column)
}

function useWrap(editor: ProgramEditor | null): void {
  const wrap = useStudioState(state => state.wrap)
  useEffect(() => editor?.setWrap(wrap), [editor, wrap])
}

function useMarks(editor: ProgramEditor | null): void {
  const studio = useStudio()
  const stale = useStudioState(state => state.stale)
  const ghost = useStudioState(state => state.ghost)
  const name = useStudioState(state => state.document)
  const found = useStudioState(state => state.found)
  useEffect(() => editor?.markFound(found.filter(one => one.document === name)), [editor, found, name])
  useEffect(() => editor?.followResults(studio.store, name), [studio, editor, name])
  useEffect(() => editor?.markStale(stale ? 'stale' : 'current'), [editor, stale])
  useEffect(() => editor?.markGhost(ghost?.document === name ? ghost.line : null), [editor, ghost, name])
  useEffect(() => {
    if (!editor || !name) return
    return studio.loop.every(10, () => {
      const running = studio.runningLine()
      editor.markRunning(running?.document === editor.document ? running.line : null)
      if (studio.cursor.playing || (studio.run?.live && studio.store.getState().following)) {
        editor.followRunning()
      }
    })
  }, [studio, editor, name])
}
