/** Names, colours and values of what is plotted. */

export class Legend {
  readonly element = document.createElement('div')
  #values: HTMLElement[] = []

  constructor() {
    this.element.className = 'plot-legend'
  }

  show(
    entries: readonly { readonly name: string; readonly symbol: string; readonly colour: string }[],
  ): void {
    this.#values = entries.map(() => document.createElement('output'))
    this.element.replaceChildren(
      ...entries.map(({ name, symbol, colour }, at) => {
        const entry = document.createElement('span')
        entry.title = symbol
        const key = document.createElement('i')
        key.style.background = colour
        entry.append(key, `${name} `, this.#values[at] ?? '')
        return entry
      }),
    )
  }

  write(values: readonly string[]): void {
    values.forEach((value, at) => {
      const output = this.#values[at]
      if (output && output.textContent !== value) output.textContent = value
    })
  }
}
