/** Beside the tabs of a group: make its panel large, close it. */
import type { IDockviewHeaderActionsProps } from 'dockview-react'
import { useMemo } from 'react'
import { words } from '../text/messages'
import { useStudio } from './context'
import { useChanges } from './hooks'

export function GroupActions({ containerApi, activePanel }: IDockviewHeaderActionsProps) {
  const studio = useStudio()
  const source = useMemo(
    () => ({
      onChange: (listener: () => void) => {
        const change = containerApi.onDidMaximizedGroupChange(listener)
        return () => change.dispose()
      },
    }),
    [containerApi],
  )
  useChanges(source)
  if (!activePanel) return null
  const large = activePanel.api.isMaximized()
  const name = `${large ? words.panel.restore : words.panel.maximise}: ${activePanel.title}`
  const close = `${words.panel.close}: ${activePanel.title}`
  return (
    <div className="group-actions">
      <button
        type="button"
        aria-label={name}
        title={name}
        onClick={() => (large ? activePanel.api.exitMaximized() : activePanel.api.maximize())}
      >
        {large ? '❐' : '□'}
      </button>
      <button type="button" aria-label={close} title={close} onClick={() => studio.dock?.close(activePanel)}>
        ×
      </button>
    </div>
  )
}
