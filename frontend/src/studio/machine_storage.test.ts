import { expect, test } from 'vitest'
import { MachineStorage } from './machine_storage'

/** Cookies as a page has them: what is written is read without its attributes, beside those of others. */
class Jar {
  readonly #kept = new Map([['other', 'a=1']])

  get cookie(): string {
    return [...this.#kept].map(([name, value]) => `${name}=${value}`).join('; ')
  }

  set cookie(text: string) {
    const [name = '', ...rest] = text.split(';')[0]?.split('=') ?? []
    this.#kept.set(name, rest.join('='))
  }
}

test('what one studio keeps is read by the next one, whatever its port', () => {
  const jar = new Jar()
  const first = new MachineStorage(() => jar)
  first.write('wrap', 'on')
  first.write('units', { length: 'in; "=' })
  const second = new MachineStorage(() => jar)
  expect([second.read('wrap'), second.read('units'), second.read('theme')]).toEqual([
    'on',
    { length: 'in; "=' },
    null,
  ])
})

test('cookies that are no settings are none', () => {
  for (const cookie of ['', 'ropsim-settings=%', 'ropsim-settings=3', 'ropsim-settings={', 'x=1'])
    expect(new MachineStorage(() => ({ cookie })).read('wrap')).toBeNull()
})
