import { history, isolateHistory, redo, undo } from '@codemirror/commands'
import { EditorState } from '@codemirror/state'
import { describe, expect, it, test } from 'vitest'
import { task } from './task_language'
import { asTaught, lastTaught, standingTaught, stands, taughtMove } from './taught_move'

const HEAD = 'program t\nunits mm, deg, s\n'

function stateOf(text: string): EditorState {
  const at = text.indexOf('|')
  const extensions = [task(), lastTaught]
  return EditorState.create({ doc: text.replace('|', ''), selection: { anchor: at }, extensions })
}

function taughtIn(state: EditorState, location: string, taken: readonly string[] = []): EditorState {
  const names = new Set([...taken, ...(state.doc.toString().toLowerCase().match(/\w+/g) ?? [])])
  return state.update(taughtMove(state, location, names)).state
}

function marked(state: EditorState): string {
  const { head } = state.selection.main
  return `${state.sliceDoc(0, head)}|${state.sliceDoc(head)}`
}

/** A text after teaching `(1)` where `|` stands, with the cursor as `|`. */
function taught(text: string, taken: readonly string[] = []): string {
  return marked(taughtIn(stateOf(text), '(1)', taken))
}

describe('the line of a taught point', () => {
  it.each([
    ['mov home\n|', 'loc p1 = (1)\nmov home\n|mov p1'],
    [`${HEAD}|`, `${HEAD}loc p1 = (1)\n|mov p1`],
    [`${HEAD}mov home|`, `${HEAD}loc p1 = (1)\nmov home\n|mov p1`],
    [`${HEAD}|mov home`, `${HEAD}loc p1 = (1)\n|mov p1\nmov home`],
    [`${HEAD}task T\n  open|\nendp`, `${HEAD}loc p1 = (1)\ntask T\n  open\n  |mov p1\nendp`],
    [`${HEAD}task T|\nendp`, `${HEAD}loc p1 = (1)\ntask T\n  |mov p1\nendp`],
    [`${HEAD}task T\n|\nendp`, `${HEAD}loc p1 = (1)\ntask T\n  |mov p1\nendp`],
    [`${HEAD}repeat 2\n    |\nendr`, `${HEAD}loc p1 = (1)\nrepeat 2\n    |mov p1\nendr`],
    ['|', 'loc p1 = (1)\n|mov p1'],
    ['# of two\n\n|', '# of two\n\nloc p1 = (1)\n|mov p1'],
    ['# of two\nopen|', '# of two\nloc p1 = (1)\nopen\n|mov p1'],
  ])('in %j', (before, behind) => {
    expect(taught(before)).toBe(behind)
  })
})

describe('where a target is missing its name belongs', () => {
  it.each([
    ['mov |', 'mov p1|'],
    ['  lin |', '  lin p1|'],
    ['circ via |', 'circ via p1|'],
    ['T a, |', 'T a, p1|'],
    ['mov |speed 20 %', 'mov p1| speed 20 %'],
    ['lin  speed 100 mm/s|', 'lin p1| speed 100 mm/s'],
    ['  lin above 5 mm  # down|', '  lin p1| above 5 mm  # down'],
  ])('in %j', (before, behind) => {
    expect(taught(`${HEAD}${before}`)).toBe(`${HEAD}loc p1 = (1)\n${behind}`)
  })

  it.each(['# up to |', 'open  // and |', '# a, |'])('but not in the comment of %j', before => {
    expect(taught(`${HEAD}${before}`)).toBe(`${HEAD}loc p1 = (1)\n${before.replace('|', '')}\n|mov p1`)
  })

  it('but in a declaration the location itself', () => {
    expect(taught(`${HEAD}loc there = |`)).toBe(`${HEAD}loc there = (1)|`)
  })
})

describe('point and move stand behind the head, where the cursor is in it', () => {
  const DECLARED = 'program t\nunits mm, deg, s\nframe f = (1, 2,\n  3)\n'
  const behind = `${DECLARED}loc p1 = (1)\n|mov p1\nmov home\n`
  it.each([
    '|program t',
    'pro|gram t',
    'program t|',
    'units mm, |deg',
    '|units',
    '|frame f',
    'frame f =| (1',
    '  |3)',
    '  3)|',
  ])('at %j', place => {
    expect(taught(`${DECLARED}mov home\n`.replace(place.replace('|', ''), place))).toBe(behind)
  })

  it('and in a blank line of it', () => {
    expect(taught('program t\n|\nunits mm\nloc a = (2)\nmov a')).toBe(
      'program t\n\nunits mm\nloc a = (2)\nloc p1 = (1)\n|mov p1\nmov a',
    )
  })

  it('and where the place has a name already', () => {
    expect(taught('program t|\nloc a = (1)\nconst n = 2')).toBe('program t\nloc a = (1)\nconst n = 2\n|mov a')
  })
})

test('a taught change stands until the history of the editor has taken it back, and again when it is redone', () => {
  let state = EditorState.create({ doc: HEAD, extensions: [task(), history(), lastTaught, standingTaught] })
  const dispatch = (transaction: { state: EditorState }) => {
    state = transaction.state
  }
  const teach = (location: string, number: number) =>
    dispatch(state.update(taughtMove(state, location, new Set()), { effects: asTaught(number) }))
  const standing = () => [1, 2].filter(number => stands(state, number))
  teach('(1)', 1)
  dispatch(state.update({ annotations: isolateHistory.of('full') }))
  teach('(2)', 2)
  expect(standing()).toEqual([1, 2])
  undo({ state, dispatch })
  expect(standing()).toEqual([1])
  undo({ state, dispatch })
  expect(standing()).toEqual([])
  redo({ state, dispatch })
  expect(standing()).toEqual([1])
  dispatch(state.update({ changes: { from: 0, insert: '# more\n' } }))
  undo({ state, dispatch })
  expect(standing()).toEqual([1])
})

describe('the name of a taught point', () => {
  it('is none that means something in the project', () => {
    const text = `${HEAD}loc p1 = (2)\nP3 = 4\n|`
    expect(taught(text, ['p4', 'p6'])).toBe(`${HEAD}loc p1 = (2)\nloc p2 = (1)\nP3 = 4\n|mov p2`)
    expect(taught(text, ['p2', 'p4'])).toContain('loc p5 = (1)\nP3')
  })

  it('is that of the same place where there is one', () => {
    expect(taught(`${HEAD}loc there = (1)\nopen|`)).toBe(`${HEAD}loc there = (1)\nopen\n|mov there`)
  })

  it('stands behind the whole last declaration of a point, before the first statement', () => {
    expect(taught(`loc a = (1,\n  2)\nvar n = 1\nn = 2\nloc late = (3)\n|`)).toBe(
      'loc a = (1,\n  2)\nloc p1 = (1)\nvar n = 1\nn = 2\nloc late = (3)\n|mov p1',
    )
  })
})

test('points that are taught one after the other follow each other; an edit or another cursor ends that', () => {
  let state = stateOf(`${HEAD}repeat 2\n  open|\nendr`)
  for (const one of ['(1)', '(2)', '(1)']) state = taughtIn(state, one)
  const head = `${HEAD}loc p1 = (1)\nloc p2 = (2)\nrepeat 2\n  open\n  mov p1\n  mov p2\n`
  expect(marked(state)).toBe(`${head}  |mov p1\nendr`)
  const { head: place } = state.selection.main
  const moved = state
    .update({ selection: { anchor: place + 1 } })
    .state.update({ selection: { anchor: place } })
  expect(marked(taughtIn(moved.state, '(2)'))).toBe(`${head}  |mov p2\n  mov p1\nendr`)
})
