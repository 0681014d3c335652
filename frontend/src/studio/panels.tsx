/** Which component shows which kind of panel. */
import type { IDockviewPanelProps } from 'dockview-react'
import { type ComponentType, type FunctionComponent, lazy, Suspense } from 'react'
import { CellPanel } from '../panels/CellPanel'
import { MessagesPanel } from '../panels/MessagesPanel'
import { ProblemsPanel } from '../panels/ProblemsPanel'
import { ProgramPanel } from '../panels/ProgramPanel'
import { StatesPanel } from '../panels/StatesPanel'
import { ViewsPanel } from '../panels/ViewsPanel'
import { words } from '../text/messages'
import type { PanelKind } from './dock'
import { useUnits } from './hooks'
import { PanelGuard } from './PanelGuard'

// Plots and their library are a chunk of their own: the 3-D picture stands before it is here.
const PlotPanel = lazy(async () => ({ default: (await import('../panels/PlotPanel')).PlotPanel }))

// Contours are for whoever asks how true the arm was.
const ContoursPanel = lazy(async () => ({ default: (await import('../panels/ContoursPanel')).ContoursPanel }))

// So are the pages of the help.
const HelpPanel = lazy(async () => ({ default: (await import('../panels/HelpPanel')).HelpPanel }))

// Jogging begins when the first picture is there.
const JogPanel = lazy(async () => ({ default: (await import('../panels/JogPanel')).JogPanel }))

// Signals are set, and runs are led by hand, when a program runs.
const SignalsPanel = lazy(async () => ({ default: (await import('../panels/SignalsPanel')).SignalsPanel }))

// The command line is for whoever tells the robot what to do line by line.
const CommandPanel = lazy(async () => ({ default: (await import('../panels/CommandPanel')).CommandPanel }))

// The tasks are for whoever makes a program without writing one.
const TasksPanel = lazy(async () => ({ default: (await import('../panels/tasks/TasksPanel')).TasksPanel }))

function guarded(kind: PanelKind, Panel: ComponentType<IDockviewPanelProps>) {
  return function Guarded(props: IDockviewPanelProps) {
    useUnits()
    return (
      <PanelGuard name={words.panels[kind]}>
        <div className={`panel panel-${kind}`}>
          <Suspense fallback={<p className="empty">{words.panel.loading}</p>}>
            <Panel {...props} />
          </Suspense>
        </div>
      </PanelGuard>
    )
  }
}

export const panels: Record<PanelKind, FunctionComponent<IDockviewPanelProps>> = {
  views: guarded('views', ViewsPanel),
  program: guarded('program', ProgramPanel),
  problems: guarded('problems', ProblemsPanel),
  messages: guarded('messages', MessagesPanel),
  states: guarded('states', StatesPanel),
  plot: guarded('plot', PlotPanel),
  contours: guarded('contours', ContoursPanel),
  jog: guarded('jog', JogPanel),
  signals: guarded('signals', SignalsPanel),
  cell: guarded('cell', CellPanel),
  tasks: guarded('tasks', TasksPanel),
  command: guarded('command', CommandPanel),
  help: guarded('help', HelpPanel),
}
