/** The tab of a panel: a name and nothing to press inside; a middle click closes it. */
import type { IDockviewPanelHeaderProps } from 'dockview-react'
import { useEffect, useState } from 'react'

export function PanelTab({ api }: IDockviewPanelHeaderProps) {
  const [title, setTitle] = useState(api.title ?? '')
  useEffect(() => {
    const change = api.onDidTitleChange(event => setTitle(event.title))
    return () => change.dispose()
  }, [api])
  return (
    <span
      className="panel-tab"
      onAuxClick={event => {
        if (event.button === 1) api.close()
      }}
    >
      {title}
    </span>
  )
}
