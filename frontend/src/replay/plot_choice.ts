/** A plot of one channel, chosen from a list. */
import { Plot } from '../plot/plot'
import type { Cursor } from '../run/cursor'
import type { ChannelInfo, Run } from '../run/run'
import { channelOf } from '../run/station'
import { channelName } from '../units/names'
import { element } from './elements'
import { words } from './words'

/** What people look at first, where it was recorded. */
const FIRST = ['q_error', 'q'] as const

export class PlotChoice {
  readonly #plot: Plot
  readonly #run: Run

  /** `host` is part of the page already: the plot takes its size and colours from there. */
  constructor(host: HTMLElement, run: Run, cursor: Cursor) {
    this.#run = run
    const area = element('div', { class: 'replay-plot' })
    const choice = element('select', { 'aria-label': words.channel })
    for (const group of new Set(run.channels.map(channel => channel.group))) {
      const list = element('optgroup', { label: words.groups[group] ?? group })
      for (const channel of run.channels) if (channel.group === group) list.append(option(channel))
      choice.append(list)
    }
    const names = run.channels.map(channel => channel.name)
    const first = FIRST.flatMap(quantity => run.stations.map(({ name }) => channelOf(quantity, name)))
    choice.value = first.find(name => names.includes(name)) ?? names[0] ?? ''
    choice.addEventListener('change', () => this.#show(choice.value))
    host.append(choice, area)
    this.#plot = new Plot(area, cursor)
    this.#show(choice.value)
  }

  #show(name: string): void {
    const channel = this.#run.channels.find(one => one.name === name)
    const columns = channel?.columns.map((_, column) => ({ channel: name, column })) ?? []
    this.#plot.show(this.#run, columns)
  }
}

function option({ name, description }: ChannelInfo): HTMLOptionElement {
  return element('option', { value: name, title: description }, channelName(name))
}
