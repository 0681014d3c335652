/** The mark upon the selected body: a tint and bright edges. */
import type { Object3D } from 'three'
import type { Bodies } from './bodies'
import { Figure } from './figure'
import type { Tint } from './tinted_arm'

export class SelectionMark {
  #figure: Figure | null = null
  #body: number | null = null

  constructor(
    private readonly parent: Object3D,
    private readonly bodies: Bodies,
    readonly tint: Tint,
  ) {}

  get body(): number | null {
    return this.#body
  }

  /** Mark a body, or none; call again when its form has changed. */
  set(body: number | null): void {
    this.#figure?.removeFrom(this.parent)
    this.#figure = null
    const [look, matrix] = [this.bodies.look(body ?? -1), this.bodies.matrix(body ?? -1)]
    this.#body = look ? body : null
    if (!look || !matrix) return
    this.#figure = Figure.at(look, matrix)
    this.#figure.dress(this.tint)
    this.parent.add(this.#figure.group)
    this.update()
  }

  /** The body may have come into the picture or left it. */
  update(): void {
    if (this.#figure && this.#body !== null) this.#figure.group.visible = this.bodies.shown(this.#body)
  }
}
