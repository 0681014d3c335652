import { expect, test } from 'vitest'
import type { Command } from '../wire/commands'
import type { StepState, TaskList, TasksChecked } from '../wire/messages'
import { joinNumbers, keptSteps, programWord, splitNumbers, splitValue } from './chosen_step'
import { ChosenTasks } from './chosen_tasks'
import { UndoStack } from './undo'

const WORLD = { gripper: 'open', held: '', parts: [], others: [] }
const LIST: TaskList = {
  type: 'task_list',
  revision: 1,
  kinds: [],
  tasks: [
    {
      name: 'pick',
      doc: '',
      group: 'pick',
      needs: [],
      parameters: [
        { name: 'P', kind: 'part', default: '', units: [], told: true, word: 'x', sentence: '' },
        { name: 'L', kind: 'location', default: '', units: [], told: false, word: 'x', sentence: '' },
        { name: 'C', kind: 'length', default: '50 mm', units: ['mm'], told: false, word: 'x', sentence: '' },
      ],
    },
  ],
  places: [],
  begin: WORLD,
  findings: [],
  problem: '',
}

function bench() {
  const sent: Command[] = []
  const kept: unknown[] = []
  const undo = new UndoStack()
  const tasks = new ChosenTasks({
    send: command => sent.push(command) > 0,
    show: () => {},
    keep: steps => kept.push(steps),
    undo,
  })
  tasks.open(null)
  tasks.receiveList(LIST)
  const last = () => sent.filter(one => one.type === 'check_tasks').at(-1)
  const answer = (revision = 1) => {
    const asked = last()
    if (!asked) return
    const steps = asked.steps.map(
      (one): StepState => ({
        call: one.name,
        accepted: true,
        message: `of ${one.name}`,
        hint: '',
        warning: '',
        told: [],
        world: WORLD,
        points: [],
      }),
    )
    const message: TasksChecked = {
      type: 'tasks_checked',
      id: asked.id,
      revision,
      steps,
      points: [],
      text: '',
      listed: '',
      problem: '',
      unchecked: '',
    }
    tasks.receive(message)
  }
  answer()
  return { tasks, sent, kept, undo, answer, last }
}

test('a chosen task has its defaults, and its state stays with it when it moves', () => {
  const { tasks, answer, undo } = bench()
  tasks.add('pick', 'a')
  tasks.add('xyz', 'b')
  expect(tasks.steps.map(one => [one.name, one.points, one.values])).toEqual([
    ['pick', [''], ['50 mm']],
    ['xyz', [], []],
  ])
  answer()
  expect(tasks.settled).toBe(false)
  answer()
  expect(tasks.settled).toBe(true)
  const [first] = tasks.steps
  tasks.move(first?.key ?? 0, 1, 'c')
  expect(tasks.stateOf(first?.key ?? 0)?.message).toBe('of pick')
  expect(tasks.steps.map(one => one.name)).toEqual(['xyz', 'pick'])
  undo.undo()
  undo.undo()
  expect(tasks.steps.map(one => one.name)).toEqual(['pick'])
  undo.redo()
  expect(tasks.steps.map(one => one.name)).toEqual(['pick', 'xyz'])
})

test('while an answer is on its way only the newest steps wait', () => {
  const { tasks, sent, answer, last } = bench()
  tasks.add('pick', 'a')
  const before = sent.length
  const key = tasks.steps[0]?.key ?? 0
  for (const typed of ['s', 's1']) tasks.edit(key, { points: [typed] })
  expect(sent.length).toBe(before)
  answer()
  expect(last()).toMatchObject({ steps: [{ name: 'pick', points: ['s1'], values: ['50 mm'] }] })
})

test('what is typed in one go is one step of undo', () => {
  const { tasks, undo } = bench()
  tasks.add('pick', 'a')
  const key = tasks.steps[0]?.key ?? 0
  for (const typed of ['s', 's1']) tasks.edit(key, { points: [typed] })
  tasks.commit('type')
  tasks.commit('type')
  expect(undo.names).toEqual(['type', 'a'])
  undo.undo()
  expect(tasks.steps[0]?.points).toEqual([''])
})

test('another revision asks for the list again', () => {
  const { tasks, sent, answer } = bench()
  tasks.add('pick', 'a')
  answer(2)
  expect(sent.filter(one => one.type === 'open_tasks').length).toBe(2)
})

test('steps that were kept come back, and what cannot be read does not', () => {
  const steps = [{ key: 3, name: 'pick', points: ['s1'], values: [] }]
  expect(keptSteps(steps)).toEqual(steps)
  for (const bad of [null, 5, [{}], [{ key: 1, name: 'a', points: [1], values: [] }]])
    expect(keptSteps(bad)).toEqual([])
})

test('fields are read and written', () => {
  expect(splitValue(' 75  mm/s ')).toEqual({ number: '75', unit: 'mm/s' })
  expect(splitNumbers('1 2 3')).toEqual(['1', '2', '3', '', '', ''])
  expect(splitNumbers('1, , 3')).toEqual(['1', '', '3', '', '', ''])
  expect(splitNumbers('1 2 3 4 5 6')).toEqual(['1', '2', '3', '4', '5', '6'])
  expect(joinNumbers(splitNumbers('1, 2, 3, , , 30'))).toBe('1, 2, 3, , , 30')
  expect(joinNumbers(['1', ' 2', '', '4', ''])).toBe('1, 2, , 4')
  expect(splitNumbers(joinNumbers(['412,5', '-147,5', '600', '', '']))).toEqual([
    '412.5',
    '-147.5',
    '600',
    '',
    '',
    '',
  ])
  for (const typed of [
    ['1 234', '', '', '', '', ''],
    ['4 ', '', '', '', '', ''],
    ['4 12', '-147.5 600', '3', '', '', ''],
  ])
    expect(splitNumbers(joinNumbers(typed))).toEqual(typed)
  expect(joinNumbers(['1 234', '', ''])).toBe('1 234,')
  expect(programWord('2 füll')).toBe('p2_f_ll')
})

test('a list that cannot be had is a problem, what was known stays, and one can try again', () => {
  const { tasks, sent } = bench()
  tasks.receiveList({ ...LIST, tasks: [], revision: 0, problem: 'it has stopped' })
  expect(tasks.problem).toBe('it has stopped')
  expect(tasks.list?.tasks.length).toBe(1)
  const before = sent.length
  tasks.retry()
  expect(tasks.problem).toBe('')
  expect(sent.slice(before).map(one => one.type)).toEqual(['open_tasks', 'check_tasks'])
  tasks.receiveList(LIST)
  expect(tasks.problem).toBe('')
})

test('where no list has come there is a problem and no list', () => {
  const tasks = new ChosenTasks({ send: () => true, show: () => {}, keep: () => {}, undo: new UndoStack() })
  tasks.open(null)
  expect([tasks.list, tasks.problem]).toEqual([null, ''])
  tasks.receiveList({ ...LIST, tasks: [], problem: 'it has stopped' })
  expect([tasks.list, tasks.problem]).toEqual([null, 'it has stopped'])
})

test('a check that nobody answers is a problem until one is answered', () => {
  const { tasks, last, answer } = bench()
  tasks.add('pick', 'a')
  const unanswered: TasksChecked = {
    type: 'tasks_checked',
    id: last()?.id ?? 0,
    revision: 0,
    steps: [],
    points: [],
    text: '',
    listed: '',
    problem: 'it has stopped',
    unchecked: '',
  }
  tasks.receive(unanswered)
  expect(tasks.problem).toBe('it has stopped')
  expect(tasks.stateOf(tasks.steps[0]?.key ?? 0)).toBe(null)
  tasks.edit(tasks.steps[0]?.key ?? 0, { points: ['s1'] })
  answer()
  expect(tasks.problem).toBe('')
})
