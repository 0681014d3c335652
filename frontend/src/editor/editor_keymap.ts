/** The editor's own keys: those of the library, but for the keys that are commands of the studio. */
import { closeBracketsKeymap } from '@codemirror/autocomplete'
import { defaultKeymap, historyKeymap, indentWithTab, redo } from '@codemirror/commands'
import { foldKeymap } from '@codemirror/language'
import { searchKeymap } from '@codemirror/search'
import type { KeyBinding } from '@codemirror/view'
import { breakLine } from './line_break'

const PLATFORMS = ['key', 'mac', 'win', 'linux'] as const

/** The library knows each of them on some systems only; the menu shows both. */
const REDO: readonly KeyBinding[] = ['Mod-Shift-z', 'Mod-y'].map(key => ({
  key,
  run: redo,
  preventDefault: true,
}))

const OWN: readonly KeyBinding[] = [
  ...closeBracketsKeymap,
  { key: 'Enter', run: breakLine, shift: breakLine },
  ...searchKeymap,
  ...historyKeymap,
  ...REDO,
  ...foldKeymap,
  ...defaultKeymap,
  indentWithTab,
]

/**
 * The keys of the editor, without those that a command of the studio takes.
 *
 * @param taken keys of commands that act while text is typed, as `Ctrl+Enter`
 */
export function editorKeys(taken: ReadonlySet<string>): readonly KeyBinding[] {
  return OWN.flatMap(withoutShift).filter(binding => !namesOf(binding).some(name => taken.has(name)))
}

/** How the studio names the keys of a binding, on any system. */
export function namesOf(binding: KeyBinding): readonly string[] {
  return PLATFORMS.flatMap(platform => binding[platform] ?? []).map(studioName)
}

/** A binding and what it does with Shift as bindings of their own: one may be taken and the other not. */
function withoutShift({ shift, ...plain }: KeyBinding): readonly KeyBinding[] {
  if (!shift) return [plain]
  const names = PLATFORMS.flatMap(platform => {
    const name = plain[platform]
    return name ? [[platform, `Shift-${name}`] as const] : []
  })
  const shifted = { ...plain, ...Object.fromEntries(names), run: shift }
  return plain.run ? [plain, shifted] : [shifted]
}

/** `Mod-Shift-z` as `Ctrl+Shift+Z`. A capital letter is typed with Shift; `-` may be the key itself. */
function studioName(key: string): string {
  const parts = key.split(/-(?!$)/)
  const last = parts.pop() ?? ''
  const has = (...names: readonly string[]) => parts.some(part => names.includes(part))
  return [
    has('Mod', 'Cmd', 'Meta', 'Ctrl') ? 'Ctrl' : '',
    has('Alt') ? 'Alt' : '',
    has('Shift') || /^[A-Z]$/.test(last) ? 'Shift' : '',
    last.length === 1 ? last.toUpperCase() : last,
  ]
    .filter(Boolean)
    .join('+')
}
