/** The commands of the shell. Panels add their own where they need to. */
import { TOPICS } from '../help/topics'
import { LAYOUTS, SHADINGS } from '../scene/settings'
import { commandWords as titles } from '../text/commands'
import { words } from '../text/messages'
import type { Menu, StudioCommand } from './commands'
import type { Dock } from './dock'
import { PANELS, PRESETS } from './dock'
import { programIn } from './document_names'
import type { Studio } from './studio'

type Extra = Partial<Pick<StudioCommand, 'enabled' | 'checked' | 'textKeeps'>>

/** Add all of them; returns the way to take them out again. */
export function addCommands(studio: Studio, openPalette: () => void): () => void {
  const removals: (() => void)[] = []
  const group = (menu: Menu, name: string) => {
    return (id: string, title: string, keys: readonly string[], run: () => void, extra: Extra = {}) => {
      removals.push(studio.commands.add({ id, title, menu, group: name, keys, run, ...extra }))
    }
  }
  addFile(studio, group('File', 'text'), group('File', 'right'))
  addEdit(studio, group('Edit', 'undo'))
  addView(studio, group)
  addSimulate(studio, group)
  const help = group('Help', 'help')
  help('help.palette', titles.palette, ['Ctrl+K', 'F1'], openPalette)
  for (const topic of TOPICS) {
    help(`help.${topic}`, titles.help[topic], topic === 'keys' ? ['Shift+F1'] : [], () => {
      studio.store.setState({ help: topic })
      studio.dock?.show('help')
    })
  }
  return () => {
    for (const remove of removals) remove()
  }
}

type Add = (id: string, title: string, keys: readonly string[], run: () => void, extra?: Extra) => void
type Grouped = (menu: Menu, name: string) => Add

function addFile(studio: Studio, text: Add, right: Add): void {
  const state = () => studio.store.getState()
  const shown = () => state().documents.find(one => one.name === state().document)
  const unsaved = () => state().documents.filter(one => one.unsaved)
  text('file.save', titles.save, ['Ctrl+S'], () => studio.save(state().document), {
    enabled: () => state().editing && state().document !== '',
  })
  text(
    'file.saveAll',
    titles.saveAll,
    ['Ctrl+Alt+S'],
    () => unsaved().forEach(one => void studio.save(one.name)),
    {
      enabled: () => state().editing && unsaved().length > 0,
    },
  )
  text('file.revert', titles.revert, [], () => studio.revert(state().document), {
    enabled: () => state().editing && shown()?.unsaved === true,
  })
  right('file.takeOver', words.takeOver, [], () => studio.takeOver(), { enabled: () => !state().editing })
  right('file.trust', words.trust.trust, [], () => studio.send({ type: 'trust', trusted: true }), {
    enabled: () => !state().trust.trusted,
  })
  right('file.revoke', words.trust.revoke, [], () => studio.send({ type: 'trust', trusted: false }), {
    enabled: () => state().trust.trusted,
  })
}

function addEdit(studio: Studio, add: Add): void {
  const { undo } = studio
  add('edit.undo', titles.undo, ['Ctrl+Z'], () => undo.undo(), {
    enabled: () => undo.next !== null,
    textKeeps: true,
  })
  add('edit.redo', titles.redo, ['Ctrl+Shift+Z', 'Ctrl+Y'], () => undo.redo(), {
    enabled: () => undo.nextRedo !== null,
    textKeeps: true,
  })
}

function addView(studio: Studio, group: Grouped): void {
  const dock = () => studio.dock
  const look = () => studio.store.getState().look
  const stage = () => studio.picture.stage
  const panels = group('View', 'panels')
  for (const kind of PANELS) {
    panels(`view.panel.${kind}`, titles.panel(words.panels[kind]), [], () => dock()?.toggle(kind), {
      checked: () => dock()?.isOpen(kind) ?? false,
    })
  }
  panels('view.plot', words.plots.add, [], () => dock()?.addPlot())
  const panel = group('View', 'panel')
  panel('view.close', words.panel.close, ['Ctrl+Alt+W'], () => dock()?.closeActive())
  panel('view.maximise', titles.maximise, ['Ctrl+Alt+M'], () => dock()?.toggleMaximised())
  panel('view.next', titles.nextPanel, ['F6'], () => dock()?.cycle(1))
  panel('view.previous', titles.previousPanel, ['Shift+F6'], () => dock()?.cycle(-1))
  const presets = group('View', 'presets')
  for (const preset of PRESETS) {
    presets(`view.preset.${preset}`, titles.presets[preset], [], () => {
      const standing = dock()
      if (standing) changeDock(studio, standing, titles.presets[preset], () => standing.preset(preset))
    })
  }
  presets('view.reset', titles.reset, [], () => {
    const standing = dock()
    if (standing) changeDock(studio, standing, titles.reset, () => standing.reset())
  })
  const layouts = group('View', 'layouts')
  for (const layout of LAYOUTS) {
    const title = words.views.layouts[layout]
    layouts(`view.layout.${layout}`, title, [], () => studio.setLook({ layout }, title), {
      checked: () => look().layout === layout,
    })
  }
  const shadings = group('View', 'shading')
  for (const shading of SHADINGS) {
    const title = titles.shading(words.views.shadings[shading])
    shadings(`view.shading.${shading}`, title, [], () => studio.setLook({ shading }, title), {
      checked: () => look().shading === shading,
    })
  }
  const picture = group('View', 'picture')
  picture(
    'view.trails',
    titles.trails,
    [],
    () => studio.setLook({ path: look().path === 'none' ? 'recent' : 'none' }, titles.trails),
    {
      checked: () => look().path !== 'none',
    },
  )
  picture('view.fit', titles.fit, [], () => stage()?.fit())
  picture('view.home', titles.home, [], () => stage()?.home())
  picture('view.ghost', words.views.hide, [], () => studio.clearGhost(), {
    enabled: () => studio.store.getState().ghost !== null,
  })
}

function addSimulate(studio: Studio, group: Grouped): void {
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
  const start = () => studio.send({ type: 'live_start', program: program(), speed: 1 })
  live('live.start', titles.live, [], start, { enabled: () => connected.enabled() && !isLive() })
  live('live.stop', titles.stopLive, [], () => studio.send({ type: 'live_control', action: 'stop' }), {
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
  const hand = group('Simulate', 'jog')
  hand('jog.start', words.jog.start, ['Ctrl+J'], () => studio.jogFromRun(), {
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

/** Move the panels in one step that can be undone. */
function changeDock(studio: Studio, dock: Dock, name: string, change: () => void): void {
  const before = dock.snapshot()
  studio.undo.do({ name, undo: () => dock.restoreFrom(before), redo: change })
}
