/** What is said of a field of a form. */
import { formWords as words } from '../../text/task_form'
import type { FormFault } from '../../wire/messages'
import { Marked } from '../Marked'

export function Faults({ faults }: { faults: readonly FormFault[] }) {
  return faults.map(one => (
    <span key={`${one.place} ${one.message}`} className={`form-fault ${one.severity}`}>
      {one.field === 'body' && one.place >= 0 ? words.line(one.place) : ''}
      <Marked text={one.message} />
      {one.hint ? (
        <span className="quiet">
          {' – '}
          <Marked text={one.hint} />
        </span>
      ) : null}
    </span>
  ))
}
