/**
 * Small things kept in the browser for all projects of this machine. Studios of other projects have other ports and so
 * stores of their own, but cookies know no ports: what is chosen stands in one, and in the store for where there are none.
 */
import { ProjectStorage } from './storage'

const COOKIE = 'ropsim-settings'

/** As long as browsers keep one [s]. */
const AGE = 400 * 24 * 3600

type Settings = Readonly<Record<string, unknown>>

/** Where cookies are read and written: the page. */
export interface CookieJar {
  cookie: string
}

export class MachineStorage {
  readonly #jar: () => CookieJar
  readonly #store = new ProjectStorage('*')

  constructor(jar: () => CookieJar) {
    this.#jar = jar
  }

  /** What was kept, by whichever studio of this machine; null where there is nothing that can be read. */
  read(name: string): unknown {
    return settingsIn(this.#jar().cookie)[name] ?? this.#store.read(name)
  }

  /** Keep a plain value. */
  write(name: string, value: unknown): void {
    this.#store.write(name, value)
    const text = encodeURIComponent(JSON.stringify({ ...settingsIn(this.#jar().cookie), [name]: value }))
    this.#jar().cookie = `${COOKIE}=${text}; Max-Age=${AGE}; Path=/; SameSite=Strict`
  }
}

/** The settings among all cookies of this machine; none where they cannot be read. */
function settingsIn(cookies: string): Settings {
  const own = cookies.split('; ').find(one => one.startsWith(`${COOKIE}=`))
  try {
    const kept: unknown = JSON.parse(decodeURIComponent(own?.slice(COOKIE.length + 1) ?? '{}'))
    return typeof kept === 'object' && kept !== null ? (kept as Settings) : {}
  } catch {
    return {}
  }
}
