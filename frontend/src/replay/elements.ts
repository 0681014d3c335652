/** Small pieces of the page. */

type Attributes = Readonly<Record<string, string>>

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...content: readonly (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag)
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value)
  made.append(...content)
  return made
}

/** A button that stays pressed; `act` hears whether it is. */
export function toggle(name: string, pressed: boolean, act: (pressed: boolean) => void): HTMLButtonElement {
  const made = element('button', { type: 'button', 'aria-pressed': String(pressed) }, name)
  made.addEventListener('click', () => {
    const next = made.getAttribute('aria-pressed') !== 'true'
    made.setAttribute('aria-pressed', String(next))
    act(next)
  })
  return made
}

/** A list to choose from, the first one at the start; `act` hears what is chosen. */
export function choice<T extends string>(
  name: string,
  options: readonly (readonly [value: T, text: string])[],
  act: (value: T) => void,
): HTMLLabelElement {
  const made = element('select')
  for (const [value, text] of options) made.append(element('option', { value }, text))
  made.addEventListener('change', () => {
    const chosen = options.find(([value]) => value === made.value)
    if (chosen) act(chosen[0])
  })
  return element('label', {}, `${name}: `, made)
}

/** A part of the replay with its heading. */
export function panel(title: string, kind: string, ...content: readonly (Node | string)[]): HTMLElement {
  return element('div', { class: `replay-panel ${kind}` }, element('h3', {}, title), ...content)
}
