/** One step: its task, its points and parameters, and what is said of it as one types. */
import { type FocusEvent, useId } from 'react'
import { type ChosenStep, withEntry } from '../../studio/chosen_step'
import { useStudio } from '../../studio/context'
import { formWords } from '../../text/task_form'
import { taskWords } from '../../text/tasks'
import type { StepState, TaskParameter } from '../../wire/messages'
import { Marked } from '../Marked'
import { PointField } from './PointField'
import { TaskPicture } from './TaskPicture'
import { ValueField } from './ValueField'

interface StepCardProps {
  readonly step: ChosenStep
  /** From 0. */
  readonly at: number
  readonly last: boolean
  /** The keyboard is nowhere now. */
  readonly onRemoved: () => void
}

export function StepCard({ step, at, last, onRemoved }: StepCardProps) {
  const { tasks, forms } = useStudio()
  const { key, name } = step
  const state = tasks.stateOf(key)
  const task = tasks.list?.tasks.find(one => one.name === name)
  const places = tasks.list?.places ?? []
  const said = useId()
  const number = at + 1
  const passed = task?.parameters.filter(one => !one.told) ?? []
  const points = passed.filter(one => one.kind === 'location')
  const values = passed.filter(one => one.kind !== 'location')
  // A whole list stands for the points behind it, too.
  const listed = points.map((_, k) => {
    const before = step.points.slice(0, k).map(one => places.find(place => place.text === one))
    return before.reduce((sum, one) => sum + (one?.count ?? 1), 0) > k ? (before.at(-1)?.list ?? '') : ''
  })
  const way = taskWords.changed(name)
  const commit = () => tasks.commit(way)
  const unfilled = state?.accepted ? [] : tasks.unfilled(step)
  const verdict = state === null || unfilled.length > 0 ? '' : state.accepted ? 'accepted' : 'refused'
  // The keyboard has left a field for another one.
  const left = (field: string) => (event: FocusEvent) => {
    if (!event.currentTarget.contains(event.relatedTarget)) tasks.leave(key, field)
  }
  return (
    <li
      className={`step ${verdict}`}
      aria-label={taskWords.step(number, name)}
      aria-current={tasks.selected === key ? 'step' : undefined}
      data-step={key}
      onFocus={() => tasks.select(key)}
    >
      <div className="step-head">
        <span className="number" aria-hidden="true">
          {number}
        </span>
        <TaskPicture name={name} />
        <input
          type="text"
          className="task-name"
          aria-label={taskWords.name}
          aria-describedby={said}
          aria-invalid={verdict === 'refused'}
          list="task-names"
          spellCheck={false}
          autoComplete="off"
          value={name}
          onChange={event => tasks.edit(key, { name: event.target.value })}
          onBlur={commit}
        />
        <span className="step-buttons">
          <button
            type="button"
            aria-label={taskWords.up(number)}
            title={taskWords.up(number)}
            disabled={at === 0}
            onClick={() => tasks.move(key, -1, taskWords.moved(name))}
          >
            ↑
          </button>
          <button
            type="button"
            aria-label={taskWords.down(number)}
            title={taskWords.down(number)}
            disabled={last}
            onClick={() => tasks.move(key, 1, taskWords.moved(name))}
          >
            ↓
          </button>
          <button
            type="button"
            aria-label={taskWords.remove(number)}
            title={taskWords.remove(number)}
            onClick={() => {
              tasks.remove(key, taskWords.removed(name))
              onRemoved()
            }}
          >
            ✕
          </button>
        </span>
      </div>
      {task ? (
        <p className="doc quiet">
          {task.doc}{' '}
          <button
            type="button"
            className="change-task"
            title={formWords.changeHint(name)}
            onClick={() => forms.open(name)}
          >
            {formWords.change} …
          </button>
        </p>
      ) : null}
      {passed.length > 0 ? (
        <div className="step-fields">
          {points.map((one, k) => (
            <PointField
              key={one.name}
              onLeft={left(`point ${k}`)}
              parameter={one.word}
              sentence={one.sentence}
              listed={listed[k] ?? ''}
              value={step.points[k] ?? ''}
              onValue={typed => tasks.edit(key, { points: withEntry(step.points, k, typed) })}
              onDone={commit}
            />
          ))}
          {values.map((one, k) => (
            <ValueField
              key={one.name}
              onLeft={left(`value ${k}`)}
              parameter={one}
              value={step.values[k] ?? ''}
              onValue={typed => tasks.edit(key, { values: withEntry(step.values, k, typed) })}
              onDone={commit}
            />
          ))}
        </div>
      ) : null}
      <Verdict
        id={said}
        state={state}
        unfilled={unfilled}
        parameters={task?.parameters ?? []}
        problem={tasks.problem !== ''}
      />
    </li>
  )
}

/** What is said of the step: accepted, or the message and the hint. */
function Verdict({
  id,
  state,
  unfilled,
  parameters,
  problem,
}: {
  id: string
  state: StepState | null
  /** Fields that nobody has filled in yet. */
  unfilled: readonly string[]
  parameters: readonly TaskParameter[]
  /** Nothing is said of any step now. */
  problem: boolean
}) {
  if (!state) {
    return (
      <p className="verdict quiet" id={id}>
        {problem ? taskWords.notChecked : taskWords.checking}
      </p>
    )
  }
  if (unfilled.length > 0) {
    return (
      <p className="verdict quiet" id={id}>
        {taskWords.toFill(unfilled.join(', '))}
      </p>
    )
  }
  const told = state.told.map(({ part, place }) => {
    const parameter = parameters.find(one => one.name === part)
    return taskWords.told(parameter?.word ?? part, place)
  })
  return (
    <p className="verdict" id={id} aria-live="polite">
      <strong>
        {state.accepted ? '✓ ' : '✕ '}
        <Marked text={state.message} />
      </strong>
      {state.warning ? (
        <span className="warning">
          <Marked text={state.warning} />
        </span>
      ) : null}
      {state.hint ? (
        <span className="hint">
          <Marked text={state.hint} />
        </span>
      ) : null}
      {told.length > 0 ? <span className="hint">{told.join(', ')}</span> : null}
    </p>
  )
}
