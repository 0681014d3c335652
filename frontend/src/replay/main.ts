/** The viewer inside a report: finds its data in the page and fills the section `replay`. */
import { PackError } from '../run/pack_file'
import { RecordedRun } from '../run/recorded_run'
import { Stage } from '../scene/stage'
import { readData } from './data'
import { element } from './elements'
import { hookOf } from './hook'
import { Replay } from './replay'
import { words } from './words'
import './replay.css'

const section = document.getElementById('replay')
if (section) void start(section)

async function start(host: HTMLElement): Promise<void> {
  const message = element('p', {}, words.reading)
  host.append(message)
  try {
    const { scene, texts, pack } = readData(document)
    const run = await RecordedRun.decode(pack, scene)
    const replay = new Replay(host, run, scene, texts)
    message.remove()
    Object.assign(window, { __ropsim: hookOf(replay, scene) })
    const ready = () => {
      host.dataset.ready = ''
    }
    if (!Stage.supported()) ready()
    else {
      const stop = replay.picture.stage.onDrawn(() => {
        stop()
        ready()
      })
    }
  } catch (error) {
    const isKnown = error instanceof PackError
    message.textContent = words.failed(isKnown ? error.message : words.unexpected)
    message.setAttribute('role', 'alert')
    if (!isKnown) throw error
  }
}
