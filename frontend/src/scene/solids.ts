/** The surface of each kind of shape that is told by numbers. */
import type { LineShape, MeshShape, Shape } from './description'
import { box, prism } from './prism'
import { cylinder, revolve, sphere } from './revolve'
import type { Solid } from './solid'

export type SolidShape = Exclude<Shape, LineShape | MeshShape>

export function solidOf(shape: SolidShape): Solid {
  switch (shape.kind) {
    case 'box':
      return box(shape.size)
    case 'cylinder':
      return cylinder(shape.radius, shape.top, shape.length)
    case 'sphere':
      return sphere(shape.radius)
    case 'revolve':
      return revolve(shape.profile)
    case 'prism':
      return prism(shape.outline, shape.length)
  }
}
