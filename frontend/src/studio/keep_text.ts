/** Ways out for a text when there is no server to save it: the clipboard, a file of the browser. */

export async function copyText(text: string): Promise<void> {
  await navigator.clipboard.writeText(text)
}

/** Let the browser save a text under the name of its file. */
export function downloadText(document: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: 'text/plain' }))
  const link = window.document.createElement('a')
  link.href = address
  link.download = document.slice(document.lastIndexOf('/') + 1)
  link.click()
  // The browser has begun to read it by then.
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
}
