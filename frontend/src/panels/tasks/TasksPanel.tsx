/** A program made without writing one: tasks are chosen, each is answered at once, and the world is carried along. */
import { useEffect, useRef, useState } from 'react'
import type { Finding } from '../../run/run'
import { useStudio, useStudioState } from '../../studio/context'
import { useChanges } from '../../studio/hooks'
import { words } from '../../text/messages'
import { formWords } from '../../text/task_form'
import { taskWords } from '../../text/tasks'
import { Marked } from '../Marked'
import { Scroll } from '../Scroll'
import { Catalogue } from './Catalogue'
import { cycleTime } from './cycle_time'
import { EndDialog } from './EndDialog'
import { headline } from './headline'
import { PointTable } from './PointTable'
import { StepCard } from './StepCard'
import { TaskForm } from './TaskForm'
import { TextView } from './TextView'
import { WorldView } from './WorldView'
import './tasks.css'

export function TasksPanel() {
  const studio = useStudio()
  const { tasks, undo, forms } = studio
  const lost = useStudioState(state => state.connection !== 'connected')
  const [choosing, setChoosing] = useState(false)
  const [text, setText] = useState(false)
  const sides = useRef<HTMLDivElement>(null)
  // The keyboard goes to the first field of a step that has come, else to the button for the next one.
  const goTo = (key: number) =>
    requestAnimationFrame(() => {
      const panel = sides.current?.closest('.panel')
      const first = (places: readonly string[]) =>
        places.map(one => panel?.querySelector<HTMLElement>(one)).find(one => one)
      const step = `[data-step="${key}"]`
      first([
        `${step} .step-fields :is(select, input)`,
        `${step} .task-name`,
        '.add-task:enabled',
        '.card',
      ])?.focus()
    })
  useChanges(tasks)
  useChanges(undo)
  useEffect(() => {
    tasks.open(studio.storage.read('steps'))
    tasks.showPoints()
    return () => tasks.hidePoints()
  }, [studio, tasks])
  const { list, steps } = tasks
  useChanges(forms)
  if (forms.form) {
    return (
      <Scroll label={formWords.title(forms.form.name)} className="tasks">
        <TaskForm />
      </Scroll>
    )
  }
  if (!list) {
    if (tasks.problem && !lost) return <Problem />
    return <p className="empty">{lost ? words.connection.lost : taskWords.waiting}</p>
  }
  const isChoosing = choosing || steps.length === 0
  return (
    <>
      <div className="toolbar">
        <button
          type="button"
          className="add-task"
          title={taskWords.addHint}
          aria-expanded={isChoosing}
          disabled={steps.length === 0}
          onClick={() => setChoosing(!choosing)}
        >
          {isChoosing && steps.length > 0 ? taskWords.closeCatalogue : taskWords.add}
        </button>
        <button
          type="button"
          className="undo"
          title={words.undo(undo.next)}
          disabled={!undo.next}
          onClick={() => undo.undo()}
        >
          {words.undo(undo.next)}
        </button>
        <button type="button" disabled={steps.length === 0} onClick={() => tasks.clear(taskWords.cleared)}>
          {taskWords.clear}
        </button>
        <button type="button" aria-pressed={text} onClick={() => setText(!text)}>
          {text ? taskWords.hideText : taskWords.text}
        </button>
        <EndButton />
      </div>
      {forms.problem ? <p className="tasks-summary error">{forms.problem}</p> : null}
      {tasks.problem ? <Problem /> : <Summary />}
      <Scroll label={taskWords.steps} className="tasks">
        <div className="tasks-sides" ref={sides}>
          <div>
            {isChoosing ? (
              <Catalogue
                tasks={list.tasks}
                onMake={() => forms.begin(list.kinds)}
                onChoose={name => {
                  tasks.add(name, taskWords.added(name))
                  setChoosing(false)
                  goTo(tasks.selected)
                }}
              />
            ) : null}
            <ol className="steps">
              {steps.map((step, at) => (
                <StepCard
                  key={step.key}
                  step={step}
                  at={at}
                  last={at === steps.length - 1}
                  onRemoved={() => goTo(-1)}
                />
              ))}
            </ol>
            {text ? <TextView /> : null}
          </div>
          <aside className="tasks-aside" aria-label={taskWords.world}>
            <WorldView />
            <PointTable />
          </aside>
        </div>
      </Scroll>
      <datalist id="task-names">
        {list.tasks.map(one => (
          <option key={one.name} value={one.name} />
        ))}
      </datalist>
      <EndDialog />
    </>
  )
}

function EndButton() {
  const { store, tasks } = useStudio()
  const editing = useStudioState(state => state.editing)
  return (
    <button
      type="button"
      className="primary end"
      title={editing ? taskWords.endHint : taskWords.viewer}
      disabled={!editing || !tasks.settled || !tasks.answer?.text}
      onClick={() => {
        tasks.leaveAll()
        store.setState({ dialog: 'endTasks', refusal: null })
      }}
    >
      {taskWords.end}
    </button>
  )
}

/** That the tasks cannot be asked now, why, and the way to ask again. */
function Problem() {
  const { tasks } = useStudio()
  return (
    <p className="tasks-summary" role="alert">
      <span className="error">{taskWords.notRead(tasks.problem)}</span>
      <button type="button" className="try-again" onClick={() => tasks.retry()}>
        {taskWords.tryAgain}
      </button>
    </p>
  )
}

/** How many steps are accepted, and how long the program takes. */
function Summary() {
  const { tasks } = useStudio()
  const { answer, estimate, steps, list } = tasks
  const wrong = list?.findings.find(one => one.severity === 'error')
  const told = wrong ? <Wrong finding={wrong} /> : null
  if (!answer || steps.length === 0) return told ? <p className="tasks-summary">{told}</p> : null
  const states = steps.map(one => {
    const state = tasks.stateOf(one.key)
    return state && !state.accepted && tasks.unfilled(one).length > 0 ? 'unfilled' : state
  })
  const time = cycleTime(answer, estimate)
  return (
    <p className="tasks-summary" role="status">
      {headline(states).map(one => (
        <span key={one.text} className={one.tone}>
          {one.text}
        </span>
      ))}
      <span>
        {taskWords.time}: <strong>{time}</strong>
      </span>
      {told}
      {answer.problem ? <span className="error">{answer.problem}</span> : null}
      {estimate?.message && estimate.message !== wrong?.message ? (
        <span className="warning">{estimate.message}</span>
      ) : null}
      {answer.unchecked ? (
        <span className="quiet" title={answer.unchecked}>
          <Marked text={answer.unchecked} />
        </span>
      ) : null}
    </p>
  )
}

/** What is wrong with a text, with the place where it stands; a click leads there. */
function Wrong({ finding }: { finding: Finding }) {
  const studio = useStudio()
  const { span, message } = finding
  const document = span ? studio.documentOf(span.source) : ''
  return (
    <span className="error">
      {span && document ? (
        <button
          type="button"
          className="wrong-place"
          onClick={() => studio.showText(document, span.line, span.column)}
        >
          {taskWords.at(document, span.line)}
        </button>
      ) : null}
      <Marked text={message} />
    </span>
  )
}
