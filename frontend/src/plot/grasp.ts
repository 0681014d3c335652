/** The time line of a plot can be taken and dragged. */
import type uPlot from 'uplot'
import type { Cursor } from '../run/cursor'

/** A press this near to the time line takes hold of it [px]. */
const REACH = 8

/** Let the pointer drag the time line; presses elsewhere are the chart's own. */
export function letGrasp(chart: uPlot, cursor: Cursor): void {
  chart.over.addEventListener(
    'mousedown',
    event => {
      const { left } = chart.over.getBoundingClientRect()
      const away = Math.abs(event.clientX - left - chart.valToPos(cursor.time, 'x'))
      if (event.button !== 0 || away > REACH) return
      event.preventDefault()
      // The chart would begin to zoom.
      event.stopImmediatePropagation()
      cursor.pause()
      const move = (next: MouseEvent) => cursor.seek(chart.posToVal(next.clientX - left, 'x'))
      const end = () => {
        removeEventListener('mousemove', move)
        removeEventListener('mouseup', end)
      }
      addEventListener('mousemove', move)
      addEventListener('mouseup', end)
    },
    { capture: true },
  )
}
