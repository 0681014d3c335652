/** What a report carries inside for its replay: elements that hold text. */
import { PackError } from '../run/pack_file'
import type { SceneDescription } from '../scene/description'

export interface ReplayData {
  readonly scene: SceneDescription
  /** Texts of the project by the names that spans use. */
  readonly texts: Readonly<Record<string, string>>
  readonly pack: ArrayBuffer
}

export function readData(page: Document): ReplayData {
  return {
    scene: json(page, 'replay-scene') as SceneDescription,
    texts: json(page, 'replay-texts') as Record<string, string>,
    pack: bytes(content(page, 'replay-pack')),
  }
}

/** The GLB file of a mesh of the scene. */
export async function embeddedMesh(address: string): Promise<ArrayBuffer> {
  return bytes(content(document, `replay-mesh-${address}`))
}

function content(page: Document, id: string): string {
  const element = page.getElementById(id)
  if (!element) throw new PackError(`The page has lost its part \`${id}\`.`)
  return element.textContent ?? ''
}

function json(page: Document, id: string): unknown {
  const text = content(page, id)
  try {
    return JSON.parse(text)
  } catch {
    throw new PackError(`The part \`${id}\` of the page is damaged.`)
  }
}

function bytes(base64: string): ArrayBuffer {
  try {
    return Uint8Array.from(atob(base64), character => character.charCodeAt(0)).buffer
  } catch {
    throw new PackError('The recorded run in the page is damaged.')
  }
}
