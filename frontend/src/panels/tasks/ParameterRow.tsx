/** The fields of one parameter: what it is called, what it is, its kind, its value where none is given, its bounds. */
import { useStudio } from '../../studio/context'
import { formWords as words } from '../../text/task_form'
import type { FormParameterFields } from '../../wire/commands'

/** Kinds that the state of the cell tells, or that have no order: no default, no bounds. */
const KNOWN: readonly string[] = ['part', 'tool', 'device', 'thing']
const UNMEASURED: readonly string[] = [...KNOWN, 'location', 'bool', 'str', 'joints']

export function ParameterRow({ parameter, place }: { parameter: FormParameterFields; place: number }) {
  const { forms } = useStudio()
  const { name, word, kind, bounds } = parameter
  const shown = word || name
  const field = (
    label: string,
    value: string,
    change: (typed: string) => Partial<FormParameterFields>,
    wide = '',
  ) => (
    <label className={wide}>
      {label}
      <input
        type="text"
        spellCheck={false}
        aria-label={`${shown}: ${label}`}
        value={value}
        onChange={event => forms.editParameter(place, change(event.target.value))}
      />
    </label>
  )
  const bound = (signs: readonly string[], label: string) => {
    const at = bounds.findIndex(one => signs.includes(one.split(' ')[0] ?? ''))
    const [sign = signs[0], ...number] = (bounds[at] ?? '').split(' ')
    return field(label, number.join(' '), typed => {
      const others = bounds.filter((_, k) => k !== at)
      return { bounds: typed ? [...others, `${sign || signs[0]} ${typed}`] : others }
    })
  }
  return (
    <div className="parameter-row">
      {field(words.word, word, typed => ({ word: typed }))}
      <label>
        {words.kind}
        <select
          aria-label={`${shown}: ${words.kind}`}
          value={kind}
          onChange={event =>
            forms.editParameter(place, { kind: event.target.value, default: '', bounds: [] })
          }
        >
          {forms.kinds.map(one => (
            <option key={one} value={one}>
              {(words.kinds as Readonly<Record<string, string>>)[one] ?? one}
            </option>
          ))}
        </select>
      </label>
      {KNOWN.includes(kind) ? null : field(words.default, parameter.default, typed => ({ default: typed }))}
      {UNMEASURED.includes(kind) ? null : bound(['>=', '>'], words.least)}
      {UNMEASURED.includes(kind) ? null : bound(['=<', '<'], words.most)}
      {field(words.variable, name, typed => ({ name: typed, called: '' }), 'short')}
      {field(words.sentence, parameter.sentence, typed => ({ sentence: typed }), 'wide')}
      <button
        type="button"
        aria-label={words.removeParameter(shown)}
        title={words.removeParameter(shown)}
        onClick={() =>
          forms.edit({ parameters: (forms.form?.parameters ?? []).filter((_, at) => at !== place) })
        }
      >
        ✕
      </button>
    </div>
  )
}
