/** The text of the program as it would be made now, for whoever wants to look. */
import { useStudio } from '../../studio/context'
import { taskWords } from '../../text/tasks'
import { Scroll } from '../Scroll'

export function TextView() {
  const { tasks } = useStudio()
  return (
    <Scroll label={taskWords.textLabel} className="task-text">
      <pre>{tasks.answer?.text || taskWords.none}</pre>
    </Scroll>
  )
}
