/** The points of the control program with their numbers; the chosen one is highlighted in the picture. */
import { useStudio } from '../../studio/context'
import { taskWords } from '../../text/tasks'

export function PointTable() {
  const { tasks } = useStudio()
  const points = tasks.answer?.points ?? []
  return (
    <section aria-label={taskWords.points}>
      <h2>{taskWords.points}</h2>
      {points.length === 0 ? (
        <p className="quiet">
          {tasks.steps.length > 0 && !tasks.settled ? taskWords.checking : taskWords.noPoints}
        </p>
      ) : (
        <table className="point-table">
          <caption>{taskWords.pointUnits}</caption>
          <thead>
            <tr>
              {taskWords.pointColumns.map(one => (
                <th key={one} scope="col">
                  {one}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {points.map((point, at) => {
              const name = point.name || taskWords.unnamed(at + 1)
              const pressed = tasks.point === at
              return (
                <tr key={name} data-selected={pressed || undefined}>
                  <th scope="row">
                    <button
                      type="button"
                      aria-pressed={pressed}
                      disabled={!point.pose}
                      title={taskWords.showPoint(name)}
                      onClick={() => tasks.showPoint(pressed ? -1 : at)}
                    >
                      {name}
                    </button>
                  </th>
                  {point.numbers ? (
                    point.numbers.map((one, k) => <td key={taskWords.pointColumns[k + 1]}>{shown(one)}</td>)
                  ) : (
                    <td colSpan={6} className="quiet">
                      {taskWords.noPose}
                    </td>
                  )}
                </tr>
              )
            })}
          </tbody>
        </table>
      )}
    </section>
  )
}

/** To a tenth, without a minus before zero. */
function shown(number: number): string {
  return number.toFixed(1).replace(/^-(0\.0+)$/, '$1')
}
