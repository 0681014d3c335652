/**
 * How the page enters the studio: it answers the challenge of each socket with its key, which it never sends, and gets a
 * ticket for requests over HTTP. The key comes in the fragment of the address and stays with the tab.
 */

const KEPT = 'ropsim key'

/** A socket that is closed with this code belongs to a studio that does not know the key. */
export const REFUSED = 4401

/** What each socket of the server says first. */
export type EntryMessage =
  | { readonly type: 'challenge'; readonly nonce: string }
  | { readonly type: 'entered'; readonly ticket: string; readonly key: string }

/** What entering needs of the browser; tests give their own. */
export interface Door {
  /** The answer to a challenge. */
  readonly answer: (nonce: string) => Promise<string>
  /** Keep what was given on entering. */
  readonly entered: (ticket: string, key: string) => void
}

let key = ''
let ticket = ''

/** Take the key from the address of the page, which loses it, or from the tab. */
export function takeKey(): void {
  const given = new URLSearchParams(location.hash.slice(1)).get('token')
  if (given) history.replaceState(null, '', location.pathname + location.search)
  key = given ?? stored()
}

/** Whether a new address, with a key of its own, was opened in this tab. */
export function hasNewKey(): boolean {
  return new URLSearchParams(location.hash.slice(1)).has('token')
}

export const door: Door = {
  answer: nonce => answerTo(nonce, key, location.port || '80'),
  entered: (newTicket, newKey) => {
    ticket = newTicket
    key = newKey
    try {
      sessionStorage.setItem(KEPT, newKey)
    } catch {
      // The browser keeps nothing: the key is lost when the page is loaded again.
    }
  },
}

/** HMAC-SHA-256 of a challenge and the port under the key, in hexadecimal digits. */
export async function answerTo(nonce: string, key: string, port: string): Promise<string> {
  if (!key) return ''
  const bytes = new TextEncoder()
  const secret = bytes.encode(key)
  const made = await crypto.subtle.importKey('raw', secret, { name: 'HMAC', hash: 'SHA-256' }, false, [
    'sign',
  ])
  const code = await crypto.subtle.sign('HMAC', made, bytes.encode(`${nonce} ${port}`))
  return [...new Uint8Array(code)].map(byte => byte.toString(16).padStart(2, '0')).join('')
}

/** Deal with a message if it belongs to entering: `in` once the page is in, `none` where it does not belong to that. */
export function enter(socket: WebSocket, message: unknown, at: Door = door): 'in' | 'answered' | 'none' {
  const said = message as EntryMessage
  if (said.type === 'challenge') {
    void at.answer(said.nonce).then(answer => {
      if (socket.readyState === 1) socket.send(JSON.stringify({ type: 'enter', answer }))
    })
    return 'answered'
  }
  if (said.type !== 'entered') return 'none'
  at.entered(said.ticket, said.key)
  return 'in'
}

/** Ask the studio over HTTP, with the ticket. */
export function ask(path: string): Promise<Response> {
  return fetch(path, { headers: { authorization: `Bearer ${ticket}` }, credentials: 'omit' })
}

function stored(): string {
  try {
    return sessionStorage.getItem(KEPT) ?? ''
  } catch {
    return ''
  }
}
