/** What is true after the chosen step: the gripper, what it holds, where each part is. */
import { useStudio } from '../../studio/context'
import { taskWords } from '../../text/tasks'

export function WorldView() {
  const { tasks } = useStudio()
  const at = tasks.steps.findIndex(one => one.key === tasks.selected)
  const step = tasks.steps[at]
  const world = step ? tasks.stateOf(step.key)?.world : tasks.list?.begin
  const title = step ? taskWords.after(at + 1, step.name) : taskWords.begin
  if (!world) {
    return step ? (
      <section aria-label={title} className="world">
        <h2>{title}</h2>
        <p className="quiet">{taskWords.notYetKnown}</p>
      </section>
    ) : null
  }
  const grippers: Readonly<Record<string, string>> = taskWords.grippers
  return (
    <section aria-label={title} className="world">
      <h2>{title}</h2>
      <dl>
        <div>
          <dt>{taskWords.gripper}</dt>
          <dd>{grippers[world.gripper] ?? taskWords.unknown}</dd>
        </div>
        <div>
          <dt>{taskWords.held}</dt>
          <dd>{world.held || taskWords.nothing}</dd>
        </div>
        {world.parts.map(({ part, place }) => (
          <div key={part}>
            <dt>{part}</dt>
            <dd>{place || taskWords.unknown}</dd>
          </div>
        ))}
        {world.others.length > 0 ? (
          <div>
            <dt>{taskWords.others}</dt>
            <dd>{world.others.join(', ')}</dd>
          </div>
        ) : null}
      </dl>
      {world.parts.length === 0 && !world.held ? <p className="quiet">{taskWords.noParts}</p> : null}
    </section>
  )
}
