/** Texts by the versions under which the server knows them, newest first forgotten last. */

/** Versions of one document that are kept: more are typed in no time that a run takes to begin. */
const MOST = 64

export class TextHistory {
  readonly #texts = new Map<string, Map<number, string>>()

  /** The server has, or gets, this text under a version. */
  remember(document: string, version: number, text: string): void {
    let versions = this.#texts.get(document)
    if (!versions) {
      versions = new Map()
      this.#texts.set(document, versions)
    }
    versions.delete(version)
    versions.set(version, text)
    for (const old of versions.keys()) {
      if (versions.size <= MOST) break
      versions.delete(old)
    }
  }

  /** The texts of these versions, as far as this page has seen them. */
  texts(versions: Readonly<Record<string, number>>): ReadonlyMap<string, string> {
    const found = new Map<string, string>()
    for (const [document, version] of Object.entries(versions)) {
      const text = this.#texts.get(document)?.get(version)
      if (text !== undefined) found.set(document, text)
    }
    return found
  }
}
