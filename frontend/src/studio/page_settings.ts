/** What the user has chosen for every project on this machine: light or dark, units, wrapped lines. */
import { setTheme, THEMES, type Theme } from '../style/scheme'
import { ANGLES, LENGTHS, METRIC, setUnits, type UnitChoice } from '../units/choice'
import { MachineStorage } from './machine_storage'
import type { Wrap } from './state'

const storage = new MachineStorage(() => document)

/** Let the page be as the user wanted it last. */
export function restoreSettings(): void {
  const theme = storage.read('theme')
  setTheme(THEMES.find(one => one === theme) ?? 'system')
  const kept = storage.read('units') as Partial<UnitChoice> | null
  setUnits({
    length: LENGTHS.find(one => one === kept?.length) ?? METRIC.length,
    angle: ANGLES.find(one => one === kept?.angle) ?? METRIC.angle,
  })
}

export function keptWrap(): Wrap {
  return storage.read('wrap') === 'on' ? 'on' : 'off'
}

export function keepWrap(wrap: Wrap): void {
  storage.write('wrap', wrap)
}

export function keepTheme(theme: Theme): void {
  setTheme(theme)
  storage.write('theme', theme)
}

export function keepUnits(units: UnitChoice): void {
  setUnits(units)
  storage.write('units', units)
}
