/** Files for the user to keep: what the page has, and what the server makes of a run. */
import { ask } from '../wire/entry'

/** Let the browser save a file. */
export function saveFile(name: string, content: Blob): void {
  const address = URL.createObjectURL(content)
  const link = document.createElement('a')
  link.href = address
  link.download = name
  link.click()
  // The browser has begun to read by then.
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
}

export function textFile(text: string, type: string): Blob {
  return new Blob([text], { type: `${type};charset=utf-8` })
}

/** Fetch a finished run in one of its forms and save it; false where the server does not have it any more. */
export async function saveRun(run: number, ending: string, name: string): Promise<boolean> {
  const answer = await ask(`/run/${run}.${ending}`)
  if (!answer.ok) return false
  saveFile(`${name}.${ending}`, await answer.blob())
  return true
}
