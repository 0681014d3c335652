/** The controls of one viewport: direction of view, projection, fit. */
import { PRESETS, type Preset, type Projection } from './settings'
import type { Words } from './words'

export interface ToolbarActions {
  readonly look: (preset: Exclude<Preset, 'custom'>) => void
  readonly switchProjection: () => void
  readonly fit: () => void
}

const ICONS = {
  perspective: '<path d="M2 4.5v9l14 3v-15zM9 3v12"/>',
  parallel: '<path d="M2.5 3.5h13v11h-13zM9 3.5v11M2.5 9h13"/>',
  fit: '<path d="M2.5 6.5v-4h4M11.5 2.5h4v4M15.5 11.5v4h-4M6.5 15.5h-4v-4M6 6h6v6H6z"/>',
}

export class Toolbar {
  readonly element = document.createElement('div')
  readonly #direction = document.createElement('select')
  readonly #custom = document.createElement('option')
  readonly #projection: HTMLButtonElement

  constructor(
    actions: ToolbarActions,
    private readonly words: Words,
  ) {
    this.element.className = 'stage-toolbar'
    this.element.setAttribute('role', 'group')
    for (const preset of PRESETS) {
      const option = document.createElement('option')
      option.value = preset
      option.textContent = words.presets[preset]
      this.#direction.append(option)
    }
    this.#custom.value = 'custom'
    this.#custom.textContent = words.presets.custom
    this.#direction.setAttribute('aria-label', words.direction)
    this.#direction.title = words.direction
    this.#direction.addEventListener('change', () => {
      const chosen = PRESETS.find(preset => preset === this.#direction.value)
      if (chosen) actions.look(chosen)
    })
    this.#projection = button(actions.switchProjection)
    const fit = button(actions.fit)
    fit.innerHTML = icon('fit')
    label(fit, words.fit)
    this.element.append(this.#direction, this.#projection, fit)
  }

  show(preset: Preset, projection: Projection): void {
    if (preset === 'custom') this.#direction.append(this.#custom)
    else this.#custom.remove()
    this.#direction.value = preset
    this.element.setAttribute('aria-label', this.words.toolbar(this.words.presets[preset]))
    label(this.#projection, this.words.projection(this.words.projections[projection]))
    this.#projection.innerHTML = icon(projection)
  }
}

function button(action: () => void): HTMLButtonElement {
  const made = document.createElement('button')
  made.type = 'button'
  made.addEventListener('click', action)
  return made
}

function label(element: HTMLElement, text: string): void {
  element.setAttribute('aria-label', text)
  element.title = text
}

function icon(name: keyof typeof ICONS): string {
  return `<svg viewBox="0 0 18 18" aria-hidden="true">${ICONS[name]}</svg>`
}
