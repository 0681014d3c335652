/** A sentence in which words between backticks are code. */

export function Marked({ text }: { text: string }) {
  const parts = text.split('`')
  // An odd backtick stands for itself.
  const whole = parts.length % 2 === 1
  if (!whole) return text
  return parts.map((part, at) =>
    // biome-ignore lint/suspicious/noArrayIndexKey: parts of one sentence never change places
    at % 2 === 1 ? <code key={at}>{part}</code> : part,
  )
}
