/** The panels of the page and where they stand: presets, the kept layout, keys. Adapter to dockview. */
import type { DockviewApi, IDockviewPanel } from 'dockview-react'
import { words } from '../text/messages'
import { isSmallWindow } from './small_window'
import type { ProjectStorage } from './storage'
import type { UndoStack } from './undo'

export const PANELS = [
  'views',
  'program',
  'problems',
  'messages',
  'states',
  'plot',
  'contours',
  'jog',
  'signals',
  'cell',
  'tasks',
  'command',
  'help',
] as const
export type PanelKind = (typeof PANELS)[number]

export const PRESETS = ['simulate', 'write', 'look', 'analyse', 'operate', 'tasks'] as const
export type DockPreset = (typeof PRESETS)[number]

const KEPT = 'panels 1'

export class Dock {
  readonly #api: DockviewApi
  readonly #storage: ProjectStorage
  readonly #undo: UndoStack
  #closed: (() => void)[] = []

  constructor(api: DockviewApi, storage: ProjectStorage, undo: UndoStack) {
    this.#api = api
    this.#storage = storage
    this.#undo = undo
    if (!this.#restore()) this.preset('simulate')
    const keep = api.onDidLayoutChange(() => storage.write(KEPT, api.toJSON()))
    this.#closed.push(() => keep.dispose())
  }

  get api(): DockviewApi {
    return this.#api
  }

  destroy(): void {
    for (const close of this.#closed) close()
  }

  isOpen(kind: PanelKind): boolean {
    return this.#api.getPanel(kind) !== undefined
  }

  /** Bring a panel to the front; one that is closed comes beside its like. */
  show(kind: PanelKind): void {
    const panel = this.#api.getPanel(kind) ?? this.#add(kind, kind, this.#neighbour(kind))
    panel.api.setActive()
    focusInside(panel)
  }

  toggle(kind: PanelKind): void {
    const panel = this.#api.getPanel(kind)
    if (panel?.api.isVisible) this.close(panel)
    else this.show(kind)
  }

  addPlot(): void {
    let number = 2
    while (this.#api.getPanel(`plot${number}`)) number++
    this.#add(`plot${number}`, 'plot', this.#neighbour('plot'), `${words.panels.plot} ${number}`)
  }

  /** Close a panel if it is open. */
  leave(kind: PanelKind): void {
    const panel = this.#api.getPanel(kind)
    if (panel) this.close(panel)
  }

  closeActive(): void {
    if (this.#api.activePanel) this.close(this.#api.activePanel)
  }

  /** Close a panel; what it showed and where it stood comes back with undo. */
  close(panel: IDockviewPanel): void {
    this.change(words.panel.closed(panel.title ?? ''), () => panel.api.close())
  }

  /** Move the panels in one step that can be undone. */
  change(name: string, act: () => void): void {
    const before = this.snapshot()
    act()
    const after = this.snapshot()
    this.#undo.did({
      name,
      undo: () => this.restoreFrom(before),
      redo: () => this.restoreFrom(after),
    })
  }

  /** One panel over the whole page, or back. */
  toggleMaximised(): void {
    const panel = this.#api.activePanel
    if (!panel) return
    if (panel.api.isMaximized()) panel.api.exitMaximized()
    else panel.api.maximize()
  }

  /** Put the keyboard into the next group of panels. */
  cycle(direction: 1 | -1): void {
    const groups = this.#api.groups
    const at = groups.findIndex(group => holdsFocus(group))
    const next = groups[(at + direction + groups.length) % groups.length] ?? groups[0]
    const panel = next?.activePanel
    if (!panel) return
    panel.api.setActive()
    focusInside(panel)
  }

  reset(): void {
    this.#storage.remove(KEPT)
    this.preset('simulate')
  }

  /** The layout as plain values, for undo. */
  snapshot(): unknown {
    return this.#api.toJSON()
  }

  restoreFrom(snapshot: unknown): void {
    this.#api.fromJSON(snapshot as Parameters<DockviewApi['fromJSON']>[0], { reuseExistingPanels: true })
  }

  preset(preset: DockPreset): void {
    const stage = this.#api.getPanel('views')
    for (const panel of [...this.#api.panels]) {
      if (panel !== stage) panel.api.close()
    }
    const views = stage ?? this.#add('views', 'views', undefined)
    const right = (kind: PanelKind, width: number) =>
      this.#add(kind, kind, { referencePanel: views, direction: 'right' }, undefined, { initialWidth: width })
    const below = (kind: PanelKind, beside: IDockviewPanel, height: number) =>
      this.#add(kind, kind, { referencePanel: beside, direction: 'below' }, undefined, {
        initialHeight: height,
      })
    const within = (kind: PanelKind, group: IDockviewPanel) =>
      this.#add(kind, kind, { referencePanel: group, direction: 'within' }, undefined, { inactive: true })
    const wide = this.#api.width
    const tall = this.#api.height
    const small = isSmallWindow() ? BESIDE_SMALL_VIEW[preset] : undefined
    if (small) {
      const main = right(small.main, Math.max(besideView(wide, tall), small.least.width))
      const six = Math.max(SIX_JOINTS, tall * 0.46)
      const isLow = tall - six < small.least.height
      const states = isLow ? within('states', main) : below('states', main, six)
      for (const kind of small.below) within(kind, states)
      for (const kind of small.behind) within(kind, main)
    } else if (preset === 'simulate') {
      const program = right('program', Math.max(300, Math.min(620, wide * 0.4)))
      const states = below('states', program, tall * 0.46)
      for (const kind of ['problems', 'messages', 'jog', 'signals', 'cell'] as const) within(kind, states)
      within('command', below('plot', views, Math.max(190, tall * 0.32)))
    } else if (preset === 'write') {
      const program = right('program', wide * 0.55)
      const problems = below('problems', program, 180)
      within('messages', problems)
      within('states', problems)
      within('cell', problems)
    } else if (preset === 'analyse') {
      const states = right('states', Math.min(420, wide * 0.34))
      within('program', states)
      within('problems', states)
      within('contours', below('plot', views, tall * 0.5))
    } else if (preset === 'operate') {
      const signals = right('signals', Math.min(420, wide * 0.36))
      const jog = below('jog', signals, tall * 0.55)
      within('states', jog)
      within('command', jog)
      within('program', signals)
    } else if (preset === 'tasks') {
      const tasks = right('tasks', Math.max(560, wide * 0.62))
      within('program', tasks)
      const jog = below('jog', views, Math.max(240, tall * 0.4))
      within('problems', jog)
      within('states', jog)
    }
    views.api.setActive()
  }

  #restore(): boolean {
    const kept = this.#storage.read(KEPT)
    if (!kept) return false
    try {
      this.restoreFrom(kept)
      return this.#api.panels.length > 0
    } catch {
      // A layout of an older page: the preset takes its place.
      this.#api.clear()
      return false
    }
  }

  #neighbour(
    kind: PanelKind,
  ): { referencePanel: IDockviewPanel; direction: 'within' | 'right' | 'below' } | undefined {
    const open = (kinds: readonly string[]) =>
      this.#api.panels.find(panel => kinds.some(one => panel.id.startsWith(one)))
    const side = open([
      'states',
      'contours',
      'jog',
      'signals',
      'cell',
      'problems',
      'messages',
      'program',
      'tasks',
    ])
    // At the foot of the views: plots, and the line for commands.
    const foot = kind === 'plot' || kind === 'command'
    const reference = foot ? (open(['plot', 'command']) ?? open(['views'])) : (side ?? this.#api.panels[0])
    if (!reference) return undefined
    if (foot && reference.id === 'views') return { referencePanel: reference, direction: 'below' }
    return { referencePanel: reference, direction: reference.id === 'views' ? 'right' : 'within' }
  }

  #add(
    id: string,
    kind: PanelKind,
    position: { referencePanel: IDockviewPanel; direction: 'within' | 'right' | 'below' } | undefined,
    title: string = words.panels[kind],
    sizes: { initialWidth?: number; initialHeight?: number; inactive?: boolean } = {},
  ): IDockviewPanel {
    return this.#api.addPanel({
      id,
      component: kind,
      title,
      ...sizes,
      ...(position ? { position } : {}),
      ...(kind === 'views' || kind === 'program' ? { renderer: 'always' as const } : {}),
    })
  }
}

/** What stands beside the views in a small window. */
interface SmallColumn {
  readonly main: PanelKind
  readonly behind: readonly PanelKind[]
  /** With the states: below the main panel, or behind it where it would be too low above them. */
  readonly below: readonly PanelKind[]
  /** What the main panel needs with its tabs to be of use, before joints and view have theirs [px]. */
  readonly least: { readonly width: number; readonly height: number }
}

const BESIDE_SMALL_VIEW: Partial<Record<DockPreset, SmallColumn>> = {
  simulate: {
    main: 'program',
    behind: [],
    below: ['problems', 'messages', 'jog', 'signals', 'cell', 'plot', 'command'],
    least: { width: 190, height: 90 },
  },
  analyse: { main: 'plot', behind: ['program'], below: ['problems'], least: { width: 190, height: 90 } },
  operate: {
    main: 'signals',
    behind: ['program'],
    below: ['jog', 'command'],
    least: { width: 270, height: 245 },
  },
  tasks: {
    main: 'tasks',
    behind: ['program'],
    below: ['jog', 'problems'],
    least: { width: 304, height: 330 },
  },
}
/** Share of the page that the views take in a small window. */
const VIEW_SHARE = 0.41
/** Tabs, tools, head and rows of six joints in a small window [px]. */
const SIX_JOINTS = 216
/** Tabs and tools above a picture, and what the result strip grows by when a result has come [px]. */
const ABOVE_VIEW = 92

/** Width of what stands beside the views in a small window [px]. */
function besideView(wide: number, tall: number): number {
  const view = (VIEW_SHARE * window.innerWidth * window.innerHeight) / Math.max(1, tall - ABOVE_VIEW)
  return Math.min(wide - view, wide * 0.4)
}

/** Whether the keyboard is in a group: in its tabs, or in a panel that may be drawn above and not inside it. */
function holdsFocus({ element, panels }: DockviewApi['groups'][number]): boolean {
  const places = [element, ...panels.map(panel => panel.view.content.element)]
  return places.some(place => place.contains(document.activeElement))
}

/** Focus the first thing in a panel that takes the keyboard. */
function focusInside(panel: IDockviewPanel): void {
  requestAnimationFrame(() => {
    const inside = panel.view.content.element
    const first = inside.querySelector<HTMLElement>('[data-first]:not(:disabled)')
    const target =
      first ??
      inside.querySelector<HTMLElement>(
        '[tabindex="0"], .cm-content, button:not(:disabled), input:not(:disabled), select:not(:disabled)',
      )
    target?.focus()
  })
}
