/** A task as a form: fields, what is said of each, and the same as text beside them. */
import { type ReactNode, useId } from 'react'
import { useStudio, useStudioState } from '../../studio/context'
import { useChanges } from '../../studio/hooks'
import { formWords as words } from '../../text/task_form'
import type { FormFault } from '../../wire/messages'
import { Scroll } from '../Scroll'
import { Faults } from './Faults'
import { FormLines } from './FormLines'
import { ParameterRow } from './ParameterRow'
import './form.css'

export function TaskForm() {
  const studio = useStudio()
  const { forms } = studio
  useChanges(forms)
  const editing = useStudioState(state => state.editing)
  const hasText = useStudioState(state => state.documents.some(one => one.name === forms.document))
  const title = useId()
  const { form } = forms
  if (!form) return null
  const wrong = (forms.checked?.faults ?? []).filter(one => one.severity === 'error').length
  const letters = form.parameters.map(one => one.name)
  return (
    <form
      className="task-form"
      aria-labelledby={title}
      onSubmit={event => {
        event.preventDefault()
        if (forms.good && editing) studio.keepTask()
      }}
    >
      <h2 id={title}>{forms.task ? words.title(forms.task) : words.titleNew}</h2>
      {form.name ? <p className="quiet">{words.where(forms.document)}</p> : null}
      <Field label={words.name} hint={words.nameHint} faults={forms.faults(['name'])}>
        {described => (
          <input
            type="text"
            value={form.name}
            spellCheck={false}
            aria-label={words.name}
            aria-describedby={described}
            onChange={event => forms.edit({ name: event.target.value })}
          />
        )}
      </Field>
      <Field label={words.doc} hint={words.docHint} faults={forms.faults(['doc'])}>
        {described => (
          <textarea
            rows={2}
            value={form.doc}
            aria-label={words.doc}
            aria-describedby={described}
            onChange={event => forms.edit({ doc: event.target.value })}
          />
        )}
      </Field>
      <fieldset>
        <legend>{words.parameters}</legend>
        <p className="quiet">{words.parametersHint}</p>
        {form.parameters.map((one, place) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a parameter is known by its place alone, its names are typed
          <ParameterRow key={place} parameter={one} place={place} />
        ))}
        <Faults faults={forms.faults(['parameters', 'params', 'words', 'range'])} />
        <button
          type="button"
          onClick={() =>
            forms.edit({
              parameters: [
                ...form.parameters,
                {
                  name: free(letters),
                  kind: 'length',
                  default: '',
                  word: '',
                  sentence: '',
                  bounds: [],
                  called: '',
                },
              ],
            })
          }
        >
          {words.addParameter}
        </button>
      </fieldset>
      <FormLines
        title={words.needs}
        field="pre"
        lines={form.needs}
        suggestions={facts(letters)}
        onLines={needs => forms.edit({ needs })}
      />
      <FormLines
        title={words.effects}
        hint={words.effectsHint}
        field="eff"
        lines={form.effects}
        suggestions={facts(letters).flatMap(one => [`+${one}`, `-${one}`])}
        onLines={effects => forms.edit({ effects })}
      />
      <FormLines
        title={words.geometry}
        field="geo"
        lines={form.geometry}
        suggestions={letters.map(one => `reachable(arm, ${one})`)}
        onLines={geometry => forms.edit({ geometry })}
      />
      <Field label={words.body} hint={words.bodyHint} faults={forms.faults(['body'])}>
        {described => (
          <textarea
            className="code"
            rows={Math.min(Math.max(form.body.split('\n').length, 4), 16)}
            value={form.body}
            spellCheck={false}
            aria-label={words.body}
            aria-describedby={described}
            onChange={event => forms.edit({ body: event.target.value })}
          />
        )}
      </Field>
      {forms.checked?.clause ? (
        <div>
          <h3>{words.clause}</h3>
          <Scroll label={words.clause} className="clause">
            <pre>{forms.checked.clause}</pre>
          </Scroll>
        </div>
      ) : null}
      <div className="form-actions">
        <span className={wrong ? 'error' : forms.asked ? 'good' : 'quiet'} role="status">
          {forms.good
            ? words.good
            : wrong
              ? words.wrong(wrong)
              : forms.asked
                ? words.checking
                : words.untouched}
        </span>
        {forms.task && hasText ? (
          <button type="button" title={forms.document} onClick={() => studio.showTaskText()}>
            {words.text}
          </button>
        ) : null}
        <button type="button" onClick={() => forms.close()}>
          {words.cancel}
        </button>
        <button
          type="submit"
          className="primary"
          disabled={!forms.good || !editing}
          title={words.keepHint(forms.document)}
        >
          {words.keep}
        </button>
      </div>
    </form>
  )
}

/** A field with its label, what is said of it, and its hint. */
function Field({
  label,
  hint,
  faults,
  children,
}: {
  label: string
  hint: string
  faults: readonly FormFault[]
  children: (described: string) => ReactNode
}) {
  const id = useId()
  return (
    <div className="form-field">
      <span className="form-label">{label}</span>
      {children(id)}
      <span id={id}>
        {faults.length > 0 ? <Faults faults={faults} /> : <span className="quiet">{hint}</span>}
      </span>
    </div>
  )
}

/** A letter that no parameter has. */
function free(letters: readonly string[]): string {
  const all = [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ']
  return all.find(one => !letters.includes(one)) ?? `A${letters.length}`
}

/** Facts that cells have, with the letters of the parameters. */
function facts(letters: readonly string[]): string[] {
  const part = letters.includes('P') ? 'P' : '_'
  const place = letters.includes('L') ? 'L' : (letters[0] ?? '_')
  return ['gripper(open)', 'gripper(closed)', `held(${part})`, `at(${part}, ${place})`, `free(${place})`]
}
