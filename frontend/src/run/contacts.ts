/** Which collisions of a run last at a time, by the places of their bodies in the scene. */
import type { SceneDescription, Vector3 } from '../scene/description'
import type { Contact } from '../wire/facts'

/** A collision as the scene shows it. */
export interface ShownContact {
  /** Places of both bodies in the scene. */
  readonly bodies: readonly number[]
  /** Where it is the deepest, in W [m]. */
  readonly place: Vector3
  readonly text: string
}

/** Times nearer than this are the same [s]: far below a control tick. */
const SAME = 1e-6

export function contactsAt(
  contacts: readonly Contact[],
  scene: Pick<SceneDescription, 'bodies'>,
  time: number,
): readonly ShownContact[] {
  const lasting = contacts.filter(one => one.begin <= time + SAME && time <= one.end + SAME)
  if (lasting.length === 0) return NONE
  const placeOf = (name: string) => scene.bodies.findIndex(body => body.name === name)
  return lasting.map(one => ({
    bodies: [placeOf(one.one), placeOf(one.other)].filter(place => place >= 0),
    place: [one.place[0] ?? 0, one.place[1] ?? 0, one.place[2] ?? 0],
    text: `${one.bodies}, ${(-1e3 * one.distance).toFixed(1)} mm deep`,
  }))
}

const NONE: readonly ShownContact[] = []
