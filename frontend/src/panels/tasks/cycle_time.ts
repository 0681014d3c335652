/** Words for how long the program of the steps takes. */
import { taskWords } from '../../text/tasks'
import type { TasksChecked, TasksEstimated } from '../../wire/messages'

/** The estimate, or that it is being made; that nobody knows where there is no program or none that ends. */
export function cycleTime(answer: TasksChecked | null, estimate: TasksEstimated | null): string {
  if (!estimate) return answer?.text ? taskWords.timing : taskWords.noTime
  return estimate.seconds === null ? taskWords.noTime : taskWords.seconds(estimate.seconds)
}
