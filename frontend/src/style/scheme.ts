/** Light or dark: as the system has it, or as the user wants it on this page. */

export const THEMES = ['system', 'light', 'dark'] as const
export type Theme = (typeof THEMES)[number]

let wanted: Theme = 'system'
let attributed = false
const listeners = new Set<() => void>()

export function theme(): Theme {
  return wanted
}

export function isDark(): boolean {
  return wanted === 'system' ? system().matches : wanted === 'dark'
}

/** Hear of every change between light and dark. Returns the way to stop that. */
export function onScheme(listener: () => void): () => void {
  const heard = () => {
    if (wanted === 'system') listener()
  }
  // The system's colours change first, then whoever reads them.
  system().addEventListener('change', heard)
  listeners.add(listener)
  return () => {
    system().removeEventListener('change', heard)
    listeners.delete(listener)
  }
}

/** Let the page be as wanted from now on; style sheets ask for `data-theme` of the root. */
export function setTheme(next: Theme): void {
  const before = attributed ? isDark() : null
  wanted = next
  if (!attributed) system().addEventListener('change', mark)
  attributed = true
  mark()
  if (before !== null && before !== isDark()) for (const listener of [...listeners]) listener()
}

function mark(): void {
  document.documentElement.dataset.theme = isDark() ? 'dark' : 'light'
}

let media: MediaQueryList | undefined
function system(): MediaQueryList {
  media ??= matchMedia('(prefers-color-scheme: dark)')
  return media
}
