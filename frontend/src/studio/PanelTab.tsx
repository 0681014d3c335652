/** The tab of a panel: a name and nothing to press inside; a middle click closes it. */
import type { IDockviewPanelHeaderProps } from 'dockview-react'
import { useEffect, useState } from 'react'
import { useStudio } from './context'

export function PanelTab({ api, containerApi }: IDockviewPanelHeaderProps) {
  const studio = useStudio()
  const [title, setTitle] = useState(api.title ?? '')
  useEffect(() => {
    const change = api.onDidTitleChange(event => setTitle(event.title))
    return () => change.dispose()
  }, [api])
  return (
    <span
      className="panel-tab"
      onAuxClick={event => {
        const panel = containerApi.getPanel(api.id)
        if (event.button === 1 && panel) studio.dock?.close(panel)
      }}
    >
      {title}
    </span>
  )
}
