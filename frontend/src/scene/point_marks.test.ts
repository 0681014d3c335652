import { Color, type InstancedMesh, Matrix4, Object3D } from 'three'
import { expect, test } from 'vitest'
import { marksOf } from '../studio/marks_of_points'
import { PointMarks } from './point_marks'

test('each point with a pose is a ball at its place, the selected one larger and in its own colour', () => {
  const parent = new Object3D()
  const marks = new PointMarks(parent)
  const [mesh] = parent.children as [InstancedMesh]
  expect(mesh.visible).toBe(false)
  marks.setColours(new Color(1, 0, 0), new Color(0, 0, 1))
  const points = [
    { name: 'a', numbers: null, pose: [1, 2, 3, 1, 0, 0, 0] },
    { name: 'b', numbers: null, pose: null },
    { name: '', numbers: null, pose: [4, 5, 6, 1, 0, 0, 0] },
  ] as const
  marks.set(marksOf(points, 2))
  expect(marks.shown.map(({ name, selected, point }) => [name, selected, ...point])).toEqual([
    ['a', false, 1, 2, 3],
    ['3', true, 4, 5, 6],
  ])
  expect([mesh.visible, mesh.count]).toEqual([true, 2])
  const drawn = [0, 1].map(at => {
    const matrix = new Matrix4()
    mesh.getMatrixAt(at, matrix)
    const colour = new Color()
    mesh.getColorAt(at, colour)
    return { x: matrix.elements[12], size: matrix.getMaxScaleOnAxis(), colour: colour.toArray() }
  })
  expect(drawn.map(one => one.x)).toEqual([1, 4])
  expect(drawn.map(one => one.colour)).toEqual([
    [1, 0, 0],
    [0, 0, 1],
  ])
  expect(drawn[1]?.size).toBeGreaterThan(drawn[0]?.size ?? Number.POSITIVE_INFINITY)
  marks.set([])
  expect(mesh.visible).toBe(false)
  marks.dispose()
  expect(parent.children).toEqual([])
})
