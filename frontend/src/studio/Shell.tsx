/** The page around the panels: menus, banners, dock, timeline, status. */
import { type DockviewApi, DockviewReact, type DockviewTheme } from 'dockview-react'
import { lazy, Suspense, useCallback, useEffect, useMemo, useState } from 'react'
import { words } from '../text/messages'
import { Banners } from './Banners'
import { addCommands } from './builtin_commands'
import { useStudio, useStudioState } from './context'
import { Dock } from './dock'
import { GroupActions } from './GroupActions'
import { MenuBar } from './MenuBar'
import { Notices } from './Notices'
import { Palette } from './Palette'
import { PanelTab } from './PanelTab'
import { panels } from './panels'
import { ResultStrip } from './ResultStrip'
import { RunPill } from './RunPill'
import { StatusBar } from './StatusBar'
import { TimelineBar } from './TimelineBar'
import { usePageEvents } from './usePageEvents'

// The dialogs of the File menu are loaded when the first of them opens.
const FileDialog = lazy(async () => ({ default: (await import('./FileDialog')).FileDialog }))

const THEME: DockviewTheme = {
  name: 'ropsim',
  className: 'dockview-theme-light ropsim-dock',
  gap: 0,
  dndTabIndicator: 'line',
}

export function Shell() {
  const studio = useStudio()
  const folder = useStudioState(state => state.folder)
  const project = useStudioState(state => state.project)
  const several = useStudioState(state => state.programs.length > 1)
  const program = useStudioState(state => state.program)
  const unsaved = useStudioState(state => state.documents.some(one => one.unsaved))
  const dialog = useStudioState(state => state.dialog)
  const [palette, setPalette] = useState(false)
  const openPalette = useCallback(() => setPalette(true), [])
  const closePalette = useCallback(() => setPalette(false), [])
  useEffect(() => addCommands(studio, openPalette), [studio, openPalette])
  usePageEvents(studio)
  useEffect(() => {
    document.title = `${unsaved ? '● ' : ''}${project ? `${project} – ` : ''}${words.product}`
  }, [project, unsaved])
  const ready = useCallback(
    (event: { api: DockviewApi }) => {
      studio.dock = new Dock(event.api, studio.storage, studio.undo)
    },
    [studio],
  )
  useEffect(() => () => studio.dock?.destroy(), [studio])
  const tabs = useMemo(() => ({ default: PanelTab }), [])
  return (
    <div className="shell">
      <header className="topbar">
        <h1 className="brand">ropsim</h1>
        <MenuBar />
        <span className="project" title={folder}>
          {several ? words.projectProgram(project, program) : project}
        </span>
        <button type="button" className="palette-button" onClick={openPalette}>
          {words.palette.open} <kbd>Ctrl+K</kbd>
        </button>
        <RunPill />
      </header>
      <Banners />
      <ResultStrip />
      <main className="dock" aria-label={words.product}>
        {folder ? (
          <DockviewReact
            components={panels}
            tabComponents={tabs}
            defaultTabComponent={PanelTab}
            rightHeaderActionsComponent={GroupActions}
            theme={THEME}
            announcements={false}
            disableTabsOverflowList={false}
            onReady={ready}
          />
        ) : (
          <p className="waiting">{words.connection.connecting}</p>
        )}
      </main>
      <footer>
        <TimelineBar />
        <StatusBar />
      </footer>
      <Notices />
      {dialog && dialog !== 'endTasks' ? (
        <Suspense fallback={null}>
          <FileDialog key={dialog} kind={dialog} />
        </Suspense>
      ) : null}
      {palette ? <Palette onClose={closePalette} /> : null}
    </div>
  )
}
