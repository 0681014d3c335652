/** All looks of a scene, made once for bodies that look alike, and the meshes that come in later. */
import type { Body, MeshShape, Shape } from './description'
import { Look } from './look'
import { type MeshData, readMesh } from './mesh_data'
import type { StageProblem } from './settings'
import type { Words } from './words'

/** Fetches a mesh by its content address: the bytes of a GLB file. */
export type MeshSource = (address: string) => Promise<ArrayBuffer>

export class Looks {
  readonly #looks = new Map<string, Look>()
  readonly #meshes = new Map<string, MeshData>()
  /** Meshes that could not be loaded, and why. */
  readonly #failed = new Map<string, string>()
  readonly #asked = new Set<string>()

  constructor(private readonly words: Words) {}

  /** The look of these shapes as far as it is known; the same object for equal shapes. */
  of(shapes: readonly Shape[]): Look {
    const meshes = shapes.filter(shape => shape.kind === 'mesh')
    const known = meshes.map(({ mesh }) => (this.#meshes.has(mesh) ? 1 : this.#failed.has(mesh) ? 2 : 0))
    const key = JSON.stringify([shapes, known])
    const look = this.#looks.get(key) ?? new Look(shapes, this.#meshes, new Set(this.#failed.keys()))
    this.#looks.set(key, look)
    return look
  }

  /** Fetch the meshes of these bodies; `changed` is called whenever one has come or failed. */
  fetch(bodies: readonly Body[], source: MeshSource, changed: () => void): void {
    for (const { mesh } of meshesOf(bodies)) {
      if (mesh === '' || this.#asked.has(mesh)) continue
      this.#asked.add(mesh)
      source(mesh)
        .then(readMesh)
        .then(data => {
          this.#meshes.set(mesh, data)
          this.#failed.delete(mesh)
        })
        .catch((error: unknown) => {
          this.#asked.delete(mesh)
          this.#failed.set(
            mesh,
            this.words.meshFailed(error instanceof Error ? error.message : String(error)),
          )
        })
        .finally(changed)
    }
  }

  /** What these bodies lack. */
  problems(bodies: readonly Body[]): StageProblem[] {
    return bodies.flatMap(body =>
      [...meshesOf([body])].flatMap(({ mesh, file, missing }) => {
        const reason = mesh === '' ? missing : this.#failed.get(mesh)
        return reason === undefined ? [] : [{ body: body.name, file, reason }]
      }),
    )
  }

  /** Forget looks that none of these is. */
  keep(used: ReadonlySet<Look>): void {
    for (const [key, look] of this.#looks) {
      if (used.has(look)) continue
      look.dispose()
      this.#looks.delete(key)
    }
  }
}

function* meshesOf(bodies: readonly Body[]): Generator<MeshShape> {
  for (const { shapes } of bodies) for (const shape of shapes) if (shape.kind === 'mesh') yield shape
}
