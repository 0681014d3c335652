/** Points of a program as they are marked in the picture. */
import type { PointMark } from '../scene/point_marks'
import type { ProgramPoint } from '../wire/messages'

/** Those that have a pose; `selected` is the place of one of all of them, -1 for none. */
export function marksOf(points: readonly ProgramPoint[], selected: number): readonly PointMark[] {
  return points.flatMap(({ name, pose }, at) =>
    pose ? [{ name: name || `${at + 1}`, pose, selected: at === selected }] : [],
  )
}
