/** Bodies in red while they collide, and a ball at the deepest point of each collision. */
import { type Color, type Object3D, Vector3 } from 'three'
import type { ShownContact } from '../run/contacts'
import type { Bodies } from './bodies'
import { Figure } from './figure'
import { PointMarks } from './point_marks'
import type { Tint } from './tinted_arm'

export class CollisionMarks {
  readonly #points: PointMarks
  /** Red figures of the bodies that have collided since the cell was loaded. */
  readonly #figures = new Map<number, Figure>()
  #shown: readonly ShownContact[] = []
  #red: ReadonlySet<number> = new Set()

  constructor(
    private readonly parent: Object3D,
    private readonly bodies: Bodies,
    private readonly tint: Tint,
  ) {
    this.#points = new PointMarks(parent)
  }

  /** Those in the picture, with their places in W. */
  get shown(): readonly (ShownContact & { readonly point: Vector3 })[] {
    return this.#shown.map(one => ({ ...one, point: new Vector3(...one.place) }))
  }

  /** Bodies that are red now. */
  get red(): readonly number[] {
    return [...this.#red].filter(body => this.bodies.shown(body)).sort((a, b) => a - b)
  }

  set colour(colour: Color) {
    this.tint.colour = colour
    this.#points.setColours(colour, colour)
  }

  /** Show these collisions and no others. */
  set(contacts: readonly ShownContact[]): void {
    this.#shown = contacts
    this.#red = new Set(contacts.flatMap(one => one.bodies))
    for (const body of this.#red) this.#dress(body)
    this.#points.set(
      contacts.map(({ text, place }) => ({ name: text, pose: [...place, 1, 0, 0, 0], selected: false })),
    )
    this.update()
  }

  /** Forms have changed. */
  refresh(): void {
    for (const figure of this.#figures.values()) figure.removeFrom(this.parent)
    this.#figures.clear()
    this.set(this.#shown)
  }

  /** Bodies may have come into the picture or left it. */
  update(): void {
    for (const [body, figure] of this.#figures) {
      figure.group.visible = this.#red.has(body) && this.bodies.shown(body)
    }
  }

  dispose(): void {
    this.#points.dispose()
    this.tint.dispose()
  }

  #dress(body: number): void {
    const [look, matrix] = [this.bodies.look(body), this.bodies.matrix(body)]
    if (this.#figures.has(body) || !look || !matrix) return
    const figure = Figure.at(look, matrix)
    figure.dress(this.tint)
    this.#figures.set(body, figure)
    this.parent.add(figure.group)
  }
}
