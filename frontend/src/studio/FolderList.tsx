/** Folders of this machine to choose from: in, up again, and projects to be taken. */
import { useEffect } from 'react'
import { fileWords } from '../text/files'
import type { FolderState } from '../wire/messages'
import { useStudio, useStudioState } from './context'

const words = fileWords.dialog

interface FolderListProps {
  /** A project was chosen; double-clicked, it is to be opened. */
  readonly onProject: (folder: FolderState, how: 'choose' | 'open') => void
}

export function FolderList({ onProject }: FolderListProps) {
  const studio = useStudio()
  const folders = useStudioState(state => state.folders)
  useEffect(() => {
    studio.listFolders(studio.store.getState().folders?.place ?? '')
  }, [studio])
  if (!folders?.place) return null
  const { place, parent } = folders
  return (
    <fieldset className="folders">
      <legend>{words.foldersIn(place)}</legend>
      <button type="button" className="folder" onClick={() => studio.listFolders('~')}>
        <span aria-hidden="true">⌂</span> {words.home}
      </button>
      {parent ? (
        <button type="button" className="folder" onClick={() => studio.listFolders(parent)}>
          <span aria-hidden="true">↑</span> {words.up}
        </button>
      ) : null}
      {folders.folders.map(one => (
        <button
          key={one.path}
          type="button"
          className="folder"
          onClick={() => (one.project ? onProject(one, 'choose') : studio.listFolders(one.path))}
          onDoubleClick={() => (one.project ? onProject(one, 'open') : undefined)}
        >
          <span aria-hidden="true">{one.project ? '●' : '▸'}</span> {one.name}{' '}
          {one.project ? <span className="quiet">{words.isProject}</span> : null}
        </button>
      ))}
      {folders.folders.length === 0 ? <p className="quiet">{words.noFolders}</p> : null}
    </fieldset>
  )
}
