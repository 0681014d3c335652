/** Small things kept in the browser for each project: layout of panels, key bindings, choices. */

export class ProjectStorage {
  readonly #prefix: string

  constructor(folder: string) {
    this.#prefix = `ropsim ${folder} `
  }

  /** What was kept, null where there is nothing that can be read. */
  read(name: string): unknown {
    try {
      const text = localStorage.getItem(this.#prefix + name)
      return text === null ? null : JSON.parse(text)
    } catch {
      return null
    }
  }

  /** Keep a plain value. A browser that keeps nothing (full, or forbidden) is no reason to fail. */
  write(name: string, value: unknown): void {
    try {
      localStorage.setItem(this.#prefix + name, JSON.stringify(value))
    } catch {
      return
    }
  }

  remove(name: string): void {
    try {
      localStorage.removeItem(this.#prefix + name)
    } catch {
      return
    }
  }
}

/** A random name that lives as long as the tab, also through a reload. */
export function tabName(): string {
  try {
    const known = sessionStorage.getItem('ropsim tab')
    if (known) return known
    const name = crypto.randomUUID()
    sessionStorage.setItem('ropsim tab', name)
    return name
  } catch {
    return crypto.randomUUID()
  }
}
