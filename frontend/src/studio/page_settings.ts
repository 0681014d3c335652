/** What the user has chosen for every project on this machine: light or dark, units. */
import { setTheme, THEMES, type Theme } from '../style/scheme'
import { ProjectStorage } from './storage'

const storage = new ProjectStorage('*')

/** Let the page be as the user wanted it last. */
export function restoreSettings(): void {
  const theme = storage.read('theme')
  setTheme(THEMES.find(one => one === theme) ?? 'system')
}

export function chooseTheme(theme: Theme): void {
  setTheme(theme)
  storage.write('theme', theme)
}
