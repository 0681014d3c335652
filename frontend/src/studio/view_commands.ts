/** Commands of the View menu: panels, layouts, how the cell is drawn, theme, units. */
import { PRESETS as DIRECTIONS, LAYOUTS, SHADINGS } from '../scene/settings'
import { words as sceneWords } from '../scene/words'
import { THEMES, theme as themeNow } from '../style/scheme'
import { commandWords as titles } from '../text/commands'
import { words } from '../text/messages'
import { ANGLES, LENGTHS, units } from '../units/choice'
import type { Add, Grouped } from './command_groups'
import { PANELS, PRESETS } from './dock'
import type { Studio } from './studio'

const directionNames = sceneWords.presets

export function addView(studio: Studio, group: Grouped): void {
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
    presets(`view.preset.${preset}`, titles.presets[preset], [], () =>
      dock()?.change(titles.presets[preset], () => dock()?.preset(preset)),
    )
  }
  presets('view.reset', titles.reset, [], () => dock()?.change(titles.reset, () => dock()?.reset()))
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
  const directions = group('View', 'directions')
  for (const direction of DIRECTIONS) {
    const title = titles.direction(directionNames[direction])
    directions(`view.direction.${direction}`, title, [], () => stage()?.look(direction))
  }
  const wrap = () => studio.store.getState().wrap
  const text = group('View', 'text')
  text(
    'view.wrap',
    titles.wrap,
    ['Alt+Z'],
    () => studio.chooseWrap(wrap() === 'on' ? 'off' : 'on', titles.wrap),
    {
      checked: () => wrap() === 'on',
    },
  )
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
  addAppearance(studio, group('View', 'theme'), group('View', 'units'))
}

/** What counts for every project of this user. */
function addAppearance(studio: Studio, theme: Add, unit: Add): void {
  for (const one of THEMES) {
    const title = titles.themes[one]
    theme(`view.theme.${one}`, title, [], () => studio.chooseTheme(one, title), {
      checked: () => themeNow() === one,
    })
  }
  for (const length of LENGTHS) {
    const title = titles.lengths[length]
    unit(`view.length.${length}`, title, [], () => studio.chooseUnits({ ...units(), length }, title), {
      checked: () => units().length === length,
    })
  }
  for (const angle of ANGLES) {
    const title = titles.angles[angle]
    unit(`view.angle.${angle}`, title, [], () => studio.chooseUnits({ ...units(), angle }, title), {
      checked: () => units().angle === angle,
    })
  }
}
