/** Keys of commands: `Ctrl+Shift+P`, `F8`, `Space`. On a Mac the command key stands for Ctrl. */

/** What a key press is called; empty for a modifier alone. */
export function keyName(event: KeyboardEvent): string {
  const { key } = event
  if (['Control', 'Shift', 'Alt', 'Meta', 'Dead', 'Unidentified'].includes(key)) return ''
  // What is typed with AltGr, such as brackets on many keyboards, comes as Ctrl+Alt on some systems.
  if (key.length === 1 && event.getModifierState?.('AltGraph')) return key.toUpperCase()
  const base = key === ' ' ? 'Space' : key.length === 1 ? key.toUpperCase() : key
  const shifted = event.shiftKey && (key.length > 1 || key === ' ' || /[a-z]/i.test(key))
  return [
    event.ctrlKey || event.metaKey ? 'Ctrl' : '',
    event.altKey ? 'Alt' : '',
    shifted ? 'Shift' : '',
    base,
  ]
    .filter(Boolean)
    .join('+')
}

/** A key as menus show it. */
export function shownKey(name: string): string {
  return name
    .replace('ArrowLeft', '←')
    .replace('ArrowRight', '→')
    .replace('ArrowUp', '↑')
    .replace('ArrowDown', '↓')
}

/** Keys that the browser keeps for itself; no command may have them. */
export const KEPT_BY_BROWSER: readonly string[] = [
  'Ctrl+W',
  'Ctrl+N',
  'Ctrl+T',
  'Ctrl+Tab',
  'Ctrl+Shift+Tab',
  'Ctrl+Shift+W',
  'Ctrl+Shift+N',
  'Ctrl+Shift+T',
  'F5',
  'Ctrl+F5',
  'Ctrl+R',
  'F11',
]

const TEXT_INPUTS = new Set(['text', 'search', 'number', 'url', 'email', 'password', 'tel'])

/** Whether keys pressed here are text. */
export function isTyping(target: EventTarget | null): boolean {
  const element = target as Partial<HTMLElement & HTMLInputElement> | null
  const tag = element?.tagName
  if (tag === 'INPUT') return TEXT_INPUTS.has(element?.type ?? 'text')
  return tag === 'TEXTAREA' || element?.isContentEditable === true
}

/** Signs that only fields for text and lists take for themselves. */
const FREE_SIGNS = /^[[\],.]$/

/**
 * Whether the element has its own use for a plain key (space presses a button, arrows move a slider). The 3-D
 * views keep the keys that they use to themselves: what comes from there is free.
 */
export function takesPlainKey(target: EventTarget | null, name: string): boolean {
  const element = target as Partial<Element> | null
  if (isTyping(target)) return true
  const takers = FREE_SIGNS.test(name)
    ? 'select, [role=menu], [role=dialog], dialog'
    : 'button, select, input, a, summary, [role=slider], [role=tab], [role=menu], [role=dialog]'
  return element?.closest?.(takers) != null
}

/** Whether a command with this key may act while text is typed. */
export function actsWhileTyping(key: string): boolean {
  return /^(Ctrl\+|Alt\+|(Shift\+)?F\d+$)/.test(key)
}
