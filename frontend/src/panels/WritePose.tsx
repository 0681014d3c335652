/** The button that writes a jogged pose into the program. */
import { useStudio, useStudioState } from '../studio/context'
import { words } from '../text/messages'

/** What is taught by hand goes into the program that is shown. */
export function WritePose({ lost }: { lost: boolean }) {
  const studio = useStudio()
  const document = useStudioState(state => state.document)
  const editing = useStudioState(state => state.editing)
  const text = studio.jog.answer?.location
  return (
    <button
      type="button"
      title={words.jog.writeTitle}
      disabled={lost || !text || !editing || !document.endsWith('.task')}
      onClick={() => {
        if (!text) return
        const back = studio.desk.teach(text)
        if (!back) {
          studio.notify('warning', words.jog.notWritten)
          return
        }
        const orSay = (step: () => boolean) => () => {
          if (!step()) studio.notify('warning', words.jog.textChanged)
        }
        const { stands } = back
        studio.undo.did({ name: words.jog.write, stands, undo: orSay(back.undo), redo: orSay(back.redo) })
      }}
    >
      {words.jog.write}
    </button>
  )
}
