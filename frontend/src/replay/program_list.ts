/** The program text: the running line is marked, a line that moves something can be chosen. */
import type { RunEvent } from '../run/run'
import { element } from './elements'
import { words } from './words'

export class ProgramList {
  readonly element = element('ol', { class: 'replay-program', 'aria-label': words.program })
  readonly #rows: HTMLLIElement[] = []
  readonly #buttons: HTMLButtonElement[] = []
  #running = 0

  constructor(
    text: string,
    steps: ReadonlyMap<number, readonly RunEvent[]>,
    private readonly choose: (line: number) => void,
  ) {
    for (const [index, code] of text.split(/\r\n|\r|\n/).entries()) {
      const line = index + 1
      const row = element('li')
      row.append(steps.has(line) ? this.#button(line, code) : element('code', {}, code || ' '))
      this.#rows.push(row)
    }
    this.element.append(...this.#rows)
    this.element.addEventListener('keydown', event => this.#key(event))
    const first = this.#buttons[0]
    if (first) first.tabIndex = 0
  }

  /** Mark the line that runs; 0 for none. The list scrolls, the page does not. */
  run(line: number): void {
    if (line === this.#running) return
    this.#rows[this.#running - 1]?.removeAttribute('aria-current')
    const row = this.#rows[line - 1]
    row?.setAttribute('aria-current', 'step')
    this.#running = line
    if (!row) return
    const { offsetTop: top, offsetHeight: height } = row
    const { scrollTop, clientHeight } = this.element
    if (top < scrollTop || top + height > scrollTop + clientHeight) {
      this.element.scrollTop = top - clientHeight / 2
    }
  }

  #button(line: number, code: string): HTMLButtonElement {
    const button = element('button', { type: 'button', tabindex: '-1' }, element('code', {}, code))
    button.addEventListener('click', () => this.choose(line))
    button.addEventListener('focus', () => this.#only(button))
    this.#buttons.push(button)
    return button
  }

  /** All lines are one stop of the tabulator; the arrow keys go on from there. */
  #only(button: HTMLButtonElement): void {
    for (const one of this.#buttons) one.tabIndex = one === button ? 0 : -1
  }

  #key(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key]
    const at = this.#buttons.indexOf(event.target as HTMLButtonElement)
    if (step === undefined || at < 0) return
    event.preventDefault()
    this.#buttons[at + step]?.focus()
  }
}
