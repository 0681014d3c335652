/** The programs of a run, one at a time: that of the station that is chosen. */
import type { Run, RunEvent } from '../run/run'
import { channelOf, type RunStation } from '../run/station'
import { choice, element } from './elements'
import { ProgramList } from './program_list'
import { stepsByLine } from './steps'
import { words } from './words'

export class ProgramChoice {
  /** The choice, where there is one, and the text. */
  readonly elements: readonly HTMLElement[]
  readonly #run: Run
  readonly #lists: readonly { readonly station: RunStation; readonly list: ProgramList }[]

  /** `choose` hears of a line and of its steps. */
  constructor(
    run: Run,
    texts: Readonly<Record<string, string>>,
    choose: (line: number, steps: readonly RunEvent[]) => void,
  ) {
    this.#run = run
    this.#lists = run.stations.map(station => {
      const { name, source } = station
      const steps = stepsByLine(run, source, name)
      const text = texts[source] ?? words.noProgram(source)
      return { station, list: new ProgramList(text, steps, line => choose(line, steps.get(line) ?? [])) }
    })
    const place = element('div', { class: 'replay-programs' })
    const show = (name: string) => {
      const shown = this.#lists.find(one => one.station.name === name) ?? this.#lists[0]
      if (shown) place.replaceChildren(shown.list.element)
    }
    show('')
    const names = run.stations.map(({ name }) => [name, name] as const)
    this.elements = names.length > 1 ? [choice(words.programOf, names, show), place] : [place]
  }

  /** Mark the lines that run at a time. */
  show(time: number): void {
    for (const { station, list } of this.#lists)
      list.run(this.#run.value(channelOf('line', station.name), 0, time))
  }
}
