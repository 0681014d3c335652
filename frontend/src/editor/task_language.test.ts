import { highlightTree, tagHighlighter, tags } from '@lezer/highlight'
import { describe, expect, it } from 'vitest'
import { parser } from './generated/task-parser.js'
import { taskLanguage } from './task_language'

/** Names of the nodes of a text with the characters they cover, in order; brackets and punctuation left out. */
function nodes(text: string, ...wanted: string[]): string[] {
  const found: string[] = []
  parser.parse(text).iterate({
    enter: node => {
      if (wanted.includes(node.name)) found.push(`${node.name} ${text.slice(node.from, node.to)}`)
    },
  })
  return found
}

function errors(text: string): number {
  let count = 0
  parser.parse(text).iterate({
    enter: node => {
      if (node.type.isError) count += 1
    },
  })
  return count
}

describe('grammar of task texts', () => {
  it('takes a unit behind a number only as a whole word', () => {
    expect(nodes('lin p blend 2 speed 200 mm/s', 'Number')).toEqual(['Number 2', 'Number 200 mm/s'])
    expect(nodes('wait 2 s', 'Number')).toEqual(['Number 2 s'])
    expect(nodes('mov p above 50 min_gap', 'Number')).toEqual(['Number 50'])
    expect(nodes('set speed 80 %', 'Number')).toEqual(['Number 80 %'])
  })

  it('reads a modern text without errors', () => {
    const text = [
      'program palletizing',
      'units mm, deg, s',
      '# 36 boxes',
      'pattern slots = grid 6 x 6 from (0, 0, 40) step (70, 0, 0), (0, 70, 0)',
      'task Pick(part: loc, clear: length = 60 mm) -> int',
      '  needs gripper open',
      '  lin part above clear speed 150 mm/s acc 2 m/s2',
      '  if part.x >= 3 then mov home',
      '  lin (300, 20,   // goes on',
      '       100; rx 90 deg, like infeed)',
      '  return 1.',
      'endp',
      'for each slot in slots',
      '  Pick infeed, n = 2',
      'endf',
      'x := 2e-3 * sin(90)',
      'q.x = q.x + 50',
      'set glue on',
    ].join('\n')
    expect(errors(text)).toBe(0)
  })

  it('reads the listing of paper 1', () => {
    const text = [
      '1. Task "grip"',
      '  mov l',
      '  endp',
      '3. Task "Palletize"',
      '  load (x, y, z), l',
      '  call grip (x, y, z)',
      '  x := x + a',
      '  Palletize p (13,5,8), (6,3,2), 0.1, 6.',
    ].join('\n')
    expect(errors(text)).toBe(0)
    expect(nodes(text, 'TaskName')).toEqual(['TaskName grip', 'TaskName Palletize'])
  })

  it('knows words in any case and tasks from variables', () => {
    expect(
      nodes('MOV Home\nPick infeed\ncount = 3', 'StatementWord', 'Word', 'TaskName', 'VariableName'),
    ).toEqual(['StatementWord MOV', 'Word Home', 'TaskName Pick', 'VariableName count'])
  })

  it('takes a unit as part of its number only', () => {
    expect(nodes('m = s * 5 mm/s + 3 s', 'Number', 'Name', 'VariableName')).toEqual([
      'VariableName m',
      'Name s',
      'Number 5 mm/s',
      'Number 3 s',
    ])
  })

  it('ends comments and texts with their line', () => {
    expect(nodes('print "a // b" # c\nprint "open\nmov home', 'Comment', 'String', 'StatementWord')).toEqual([
      'StatementWord print',
      'String "a // b"',
      'Comment # c',
      'StatementWord print',
      'String "open',
      'StatementWord mov',
    ])
  })

  it('takes `end` for a closer where it stands alone', () => {
    const text = 'task T\n  END. # x\nend = end + 1\nlin q at 4 mm before end do set glue on\nend'
    expect(errors(text)).toBe(0)
    expect(nodes(text, 'End', 'VariableName')).toEqual(['End END', 'VariableName end', 'End end'])
  })

  it('goes on after a wrong line', () => {
    expect(nodes('mov ??\ntask T\nendp', 'TaskName')).toEqual(['TaskName T'])
    expect(nodes('mov (1, 2\ntask T\nendp', 'Task', 'StatementWord').at(-1)).toBe('StatementWord endp')
  })
})

describe('colours of task texts', () => {
  it('tell tasks where they are defined and called, words, numbers and variables apart', () => {
    const text = 'task Pick(a: loc)\nendp\nPick infeed, 5 mm # x'
    const highlighter = tagHighlighter([
      { tag: tags.definition(tags.function(tags.variableName)), class: 'definition' },
      { tag: tags.function(tags.variableName), class: 'call' },
      { tag: tags.keyword, class: 'keyword' },
      { tag: tags.variableName, class: 'variable' },
      { tag: tags.number, class: 'number' },
      { tag: tags.lineComment, class: 'comment' },
    ])
    const found: string[] = []
    highlightTree(taskLanguage.parser.parse(text), highlighter, (from, to, kind) => {
      found.push(`${kind} ${text.slice(from, to)}`)
    })
    expect(found).toEqual([
      'keyword task',
      'definition Pick',
      'variable a',
      'keyword loc',
      'keyword endp',
      'call Pick',
      'variable infeed',
      'number 5 mm',
      'comment # x',
    ])
  })
})
