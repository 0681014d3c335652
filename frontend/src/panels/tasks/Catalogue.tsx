/** The tasks there are, in groups, each with a picture and a sentence. */
import { formWords } from '../../text/task_form'
import { taskWords } from '../../text/tasks'
import type { TaskChoice } from '../../wire/messages'
import { TaskPicture } from './TaskPicture'

interface CatalogueProps {
  readonly tasks: readonly TaskChoice[]
  readonly onChoose: (name: string) => void
  /** A task that is not there yet is wanted. */
  readonly onMake: () => void
}

/** Groups that have words stand first, in the order of these; further ones have the name of their file. */
const ORDER = Object.keys(taskWords.groups)

export function Catalogue({ tasks, onChoose, onMake }: CatalogueProps) {
  const groups = [...new Set(tasks.map(one => one.group))].sort((a, b) => rank(a) - rank(b))
  return (
    <section className="catalogue" aria-label={taskWords.catalogue}>
      <p className="quiet">{taskWords.catalogueHint}</p>
      <button type="button" className="make-task" title={formWords.makeHint} onClick={onMake}>
        {formWords.make} …
      </button>
      {groups.map(group => (
        <section key={group} aria-label={titleOf(group)}>
          <h2>{titleOf(group)}</h2>
          <div className="cards">
            {tasks
              .filter(one => one.group === group)
              .map(one => (
                <button key={one.name} type="button" className="card" onClick={() => onChoose(one.name)}>
                  <TaskPicture name={one.name} />
                  <span>
                    <strong>{one.name}</strong>
                    <span className="doc">{one.doc}</span>
                  </span>
                </button>
              ))}
          </div>
        </section>
      ))}
    </section>
  )
}

function rank(group: string): number {
  const at = ORDER.indexOf(group)
  return group === '' ? -1 : at < 0 ? ORDER.length : at
}

function titleOf(group: string): string {
  return (taskWords.groups as Readonly<Record<string, string>>)[group] ?? group
}
