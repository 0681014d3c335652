import { expect, test } from 'vitest'
import type { Command } from '../wire/commands'
import { TaskForms } from './task_forms'

const FAULT = { field: 'name', place: 0, severity: 'error', message: 'a task needs a name', hint: '' }

function forms() {
  const sent: Command[] = []
  const made = new TaskForms({ send: command => sent.push(command) > 0 })
  const answer = (id: number) =>
    made.receiveChecked({ type: 'task_form_checked', id, text: '', clause: '', faults: [FAULT] })
  return { made, sent, answer }
}

test('nothing is said of a new form before something was typed', () => {
  const { made, sent, answer } = forms()
  made.begin([])
  expect([made.asked, sent.length]).toEqual([false, 0])
  made.edit({ doc: 'Rests.' })
  expect(made.asked).toBe(true)
  answer(1)
  expect(made.faults(['name'])).toEqual([FAULT])
})

test('what was said of one form is not said of the next one', () => {
  const { made, answer } = forms()
  made.begin([])
  made.edit({ doc: 'Rests.' })
  made.close()
  made.begin([])
  answer(1)
  expect([made.asked, made.faults(['name'])]).toEqual([false, []])
})
