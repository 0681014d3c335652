/** Texts that are not saved while there is no server: each can be copied or saved to a file. */
import { useState } from 'react'
import { words } from '../text/messages'
import { useStudio, useStudioState } from './context'
import { copyText, downloadText } from './keep_text'

export function UnsentTexts() {
  const studio = useStudio()
  const documents = useStudioState(state => state.documents)
  const [copied, setCopied] = useState('')
  const unsaved = documents.filter(one => one.unsaved)
  const copy = (name: string) =>
    copyText(studio.text(name)).then(
      () => setCopied(name),
      () => studio.notify('error', words.unsent.notCopied),
    )
  if (unsaved.length === 0) return null
  return (
    <ul className="unsent" aria-label={words.unsent.texts}>
      {unsaved.map(({ name }) => (
        <li key={name}>
          <code>{name}</code>
          <button type="button" onClick={() => void copy(name)}>
            {copied === name ? words.unsent.copied : words.unsent.copy}
          </button>
          <button type="button" onClick={() => downloadText(name, studio.text(name))}>
            {words.unsent.save}
          </button>
        </li>
      ))}
    </ul>
  )
}
