/** Commands of the Simulate menu: time, runs, live runs, jogging. */
import { commandWords as titles } from '../text/commands'
import { words } from '../text/messages'
import type { Grouped } from './command_groups'
import { programIn } from './document_names'
import type { LiveOrder } from './live_orders'
import type { Studio } from './studio'

export function addSimulate(studio: Studio, group: Grouped): void {
  const { cursor, jog, signals, transport } = studio
  const state = () => studio.store.getState()
  const has = { enabled: () => studio.run !== null }
  const time = group('Simulate', 'time')
  time('timeline.play', titles.play, ['Space'], () => transport.toggle(), has)
  time('timeline.next', titles.next, ['ArrowRight', '.'], () => transport.nextStep(), has)
  time('timeline.previous', titles.previous, ['ArrowLeft', ','], () => transport.previousStep(), has)
  time('timeline.nextFinding', titles.nextFinding, ['Shift+ArrowRight'], () => transport.nextFinding(), has)
  time(
    'timeline.previousFinding',
    titles.previousFinding,
    ['Shift+ArrowLeft'],
    () => transport.previousFinding(),
    has,
  )
  time('timeline.start', titles.start, ['Home'], () => transport.go(0), has)
  time('timeline.end', titles.end, ['End'], () => transport.go(cursor.end), has)
  const range = group('Simulate', 'range')
  range('timeline.from', titles.repeatFrom, ['['], () => transport.repeatFrom(), has)
  range('timeline.until', titles.repeatUntil, [']'], () => transport.repeatUntil(), has)
  range('timeline.repeat', titles.repeat, [], () => transport.repeat(), {
    ...has,
    checked: () => cursor.loop !== null,
  })
  range('timeline.in', titles.zoomIn, [], () => studio.timeline?.zoom('in'), has)
  range('timeline.out', titles.zoomOut, [], () => studio.timeline?.zoom('out'), has)
  range('timeline.whole', titles.wholeRun, [], () => studio.timeline?.fit(), has)
  const run = group('Simulate', 'run')
  const connected = { enabled: () => state().connection === 'connected' }
  const busy = () => ['waiting', 'running'].includes(state().status?.state ?? '')
  const program = () => state().program
  run('run.now', titles.run, ['Ctrl+Enter'], () => runNow(studio, 'dynamic'), connected)
  run('run.kinematic', titles.kinematic, [], () => runNow(studio, 'kinematic'), connected)
  run('run.cancel', titles.cancel, [], () => studio.send({ type: 'cancel' }), { enabled: busy })
  const live = group('Simulate', 'live')
  const isLive = () => state().live !== null && state().live?.state !== 'over'
  const start = (begin: 'running' | 'held') => () =>
    studio.send({ type: 'live_start', program: program(), speed: 1, begin })
  const free = { enabled: () => connected.enabled() && !isLive() }
  live('live.start', titles.live, [], start('running'), free)
  live('live.startHeld', titles.liveHeld, [], start('held'), free)
  const order = (order: LiveOrder) => () => studio.live.order(order)
  const isIn = (live: 'running' | 'held') => ({ enabled: () => studio.live.state === live })
  live('live.hold', titles.holdLive, [], order('hold'), isIn('running'))
  live('live.continue', titles.continueLive, [], order('continue'), isIn('held'))
  live('live.step', titles.stepLive, [], order('step'), isIn('held'))
  live('live.stop', titles.stopLive, [], order('stop'), {
    enabled: isLive,
  })
  live('live.follow', words.run.follow, [], () => studio.follow(), {
    enabled: () => isLive() && !state().following,
  })
  live('live.arm', titles.arm, ['Ctrl+Alt+K'], () => (signals.armed ? signals.disarm() : signals.arm()), {
    checked: () => signals.armed,
  })
  live('live.forget', words.signals.forget, [], () => studio.forgetPresses(), {
    enabled: () => (state().status?.inputs ?? 0) > 0 || state().presses.length > 0,
  })
  const told = group('Simulate', 'command')
  told('command.line', titles.commandLine, ['Ctrl+Alt+C'], () => studio.dock?.show('command'))
  told('command.undo', titles.undoCommand, [], () => void studio.commandLine.tell('undo'), {
    enabled: () => connected.enabled() && !isLive() && studio.commandLine.commands > 0,
  })
  told('command.back', titles.programRun, [], () => studio.showProgramRun(), {
    enabled: () => state().told && state().finished > 0,
  })
  const hand = group('Simulate', 'jog')
  hand('jog.start', words.jog.start, ['Ctrl+J'], () => studio.jogInSight(), {
    enabled: () => connected.enabled() && state().scene !== null,
  })
  hand('jog.stop', words.jog.back, [], () => jog.stop(), { enabled: () => jog.q !== null })
  hand(
    'timeline.line',
    titles.runningLine,
    [],
    () => {
      const line = studio.runningLine()
      if (line) studio.goTo(line.document, line.line)
    },
    has,
  )
}

/** Simulate the program in the editor; where that shows none, the last one again. */
function runNow(studio: Studio, fidelity: 'dynamic' | 'kinematic'): void {
  const { document, programs, program } = studio.store.getState()
  studio.desk.flush()
  studio.send({ type: 'run', program: programIn(document, programs) || program, fidelity })
}
