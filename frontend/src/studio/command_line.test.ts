import { expect, test } from 'vitest'
import type { Command } from '../wire/commands'
import type { ToldLine } from '../wire/messages'
import { CommandHistory } from './command_history'
import { CommandLine, commonStart } from './command_line'
import { UndoStack } from './undo'

function line(kept: unknown = null) {
  const sent: Command[] = []
  const shown: (readonly [number, number])[] = []
  const undo = new UndoStack()
  const left: string[] = []
  const commandLine = new CommandLine({
    send: command => sent.push(command) > 0,
    show: (run, since) => shown.push([run, since]),
    keep: () => {},
    trouble: () => {},
    leave: () => left.push('left'),
    undo,
  })
  commandLine.open(kept)
  const told = () => sent.filter(one => one.type === 'tell_robot').map(one => one.line)
  /** The answer of the server to what was told last. */
  const answer = (outcome: ToldLine['outcome'], commands: number, run = 0) => {
    const last = sent.filter(one => one.type === 'tell_robot').at(-1)
    const told = { line: last?.line ?? '', outcome, told: [], findings: [], first: 1, run, since: 0.5 }
    commandLine.receive({ type: 'line_answered', id: last?.id ?? 0, line: told, commands })
  }
  const offer = (begun: string, ...words: string[]) => {
    commandLine.complete()
    const asked = sent.at(-1)
    if (asked?.type !== 'complete_line') throw new Error('nothing was asked')
    commandLine.receiveWords({ type: 'words_offered', id: asked.id, begun, words })
    return asked.line
  }
  const say = (text: string) => {
    commandLine.type(text)
    commandLine.enter()
  }
  return { commandLine, sent, shown, undo, left, told, answer, offer, say }
}

test('a line is told once, and its run is shown from where its motion begins', () => {
  const { commandLine, told, answer, shown, say } = line()
  say('mov home')
  expect([commandLine.typed, commandLine.busy]).toEqual(['', true])
  answer('moved', 1, 7)
  expect(told()).toEqual(['mov home'])
  expect(shown).toEqual([[7, 0.5]])
  expect([commandLine.busy, commandLine.commands, commandLine.lines.length]).toEqual([false, 1, 1])
})

test('a block is typed line by line, and an empty line ends it', () => {
  const { commandLine, told, answer, say } = line()
  say('repeat 2')
  answer('open', 0)
  expect([commandLine.block, commandLine.lines]).toEqual(['repeat 2', []])
  say('wait 1 s')
  answer('open', 0)
  say('')
  expect(told().at(-1)).toBe('repeat 2\nwait 1 s\n')
  answer('refused', 0)
  expect(commandLine.block).toBe('')
})

test('an empty line alone says nothing', () => {
  const { sent, say } = line()
  say('  ')
  expect(sent.map(one => one.type)).toEqual(['open_command_line'])
})

test('older lines come back, and at last what was being typed', () => {
  const { commandLine } = line(['mov a', 'mov b'])
  commandLine.type('li')
  commandLine.up()
  expect(commandLine.typed).toBe('mov b')
  commandLine.up()
  commandLine.up()
  expect(commandLine.typed).toBe('mov a')
  commandLine.down()
  commandLine.down()
  expect(commandLine.typed).toBe('li')
})

test('the history keeps no line twice in a row and no blank one', () => {
  const history = new CommandHistory('damaged')
  for (const one of ['a', 'a', ' ', 'b', 'a']) history.add(one)
  expect(history.lines).toEqual(['a', 'b', 'a'])
})

test('one word ends the line, several are listed and chosen with the cursor keys', () => {
  const { commandLine, offer, told } = line()
  commandLine.type('mov pi')
  expect(offer('pi', 'pick_up')).toBe('mov pi')
  expect([commandLine.typed, commandLine.offered]).toEqual(['mov pick_up', []])
  commandLine.type('w')
  offer('w', 'wait', 'while', 'with')
  commandLine.down()
  commandLine.down()
  commandLine.enter()
  expect([commandLine.typed, commandLine.offered, told()]).toEqual(['while', [], []])
})

test('words for a line that has been typed on are not taken', () => {
  const { commandLine, sent } = line()
  commandLine.type('mov p')
  commandLine.complete()
  commandLine.type('mov q')
  const asked = sent.at(-1)
  if (asked?.type !== 'complete_line') throw new Error('nothing was asked')
  commandLine.receiveWords({ type: 'words_offered', id: asked.id, begun: 'p', words: ['pick_up'] })
  expect(commandLine.typed).toBe('mov q')
})

test('the step back takes the command back, and forth tells it again', () => {
  const { undo, told, answer, say } = line()
  say('mov a')
  answer('moved', 1)
  say('mov b')
  answer('moved', 2)
  undo.undo()
  undo.undo()
  answer('moved', 1)
  answer('moved', 0)
  undo.redo()
  answer('moved', 1)
  expect(told()).toEqual(['mov a', 'mov b', 'undo', 'undo', 'mov a'])
  expect(undo.names).toEqual(['Command mov a'])
})

test('a command that is not the last one any more is not taken back', () => {
  const { undo, told, answer, say } = line()
  say('mov a')
  answer('moved', 1)
  say('undo')
  answer('moved', 0)
  undo.undo()
  expect(told()).toEqual(['mov a', 'undo'])
})

test('escape closes the list, then gives up what is carried out, then the block', () => {
  const { commandLine, sent, answer, offer, say } = line()
  say('repeat 2')
  commandLine.escape()
  expect(sent.at(-1)?.type).toBe('give_up_line')
  answer('open', 0)
  commandLine.type('w')
  offer('w', 'wait', 'with')
  commandLine.escape()
  expect([commandLine.offered, commandLine.block]).toEqual([[], 'repeat 2'])
  commandLine.escape()
  expect(commandLine.block).toBe('')
})

test('who says that it is over leaves', () => {
  const { left, answer, say } = line()
  say('quit')
  answer('over', 0)
  expect(left).toEqual(['left'])
})

test('what all words begin with', () => {
  expect(commonStart(['wait', 'Wake', 'wa'])).toBe('wa')
  expect(commonStart([])).toBe('')
})
