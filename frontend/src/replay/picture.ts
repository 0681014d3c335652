/** The 3-D views of a replay with their few switches. */
import { contactsAt } from '../run/contacts'
import type { Run } from '../run/run'
import type { SceneDescription } from '../scene/description'
import { type Move, movesAmong, pathWindow } from '../scene/path_window'
import { type FrameKind, PATHS, type PathShown, type Theme } from '../scene/settings'
import { type MeshSource, Stage } from '../scene/stage'
import { choice, element, toggle } from './elements'
import { words } from './words'

const FRAMES: ReadonlySet<FrameKind> = new Set<FrameKind>(['world', 'base', 'frame', 'tcp'])
const NO_FRAMES: ReadonlySet<FrameKind> = new Set<FrameKind>()

export class Picture {
  readonly element = element('div', { class: 'replay-picture' })
  readonly stage: Stage
  readonly #poses: Float32Array
  readonly #visible: Uint8Array
  readonly #run: Run
  readonly #scene: SceneDescription
  /** By station. */
  readonly #moves: readonly (readonly Move[])[]
  #path: PathShown = 'recent'
  #time = 0

  constructor(run: Run, scene: SceneDescription, meshes: MeshSource) {
    this.#run = run
    this.#scene = scene
    this.#moves = run.stations.map(({ name }) => movesAmong(run.events, name))
    this.#poses = new Float32Array(7 * scene.bodies.length)
    this.#visible = new Uint8Array(scene.bodies.length)
    const host = element('div', { class: 'replay-stage', role: 'group', 'aria-label': words.views })
    const dark = matchMedia('(prefers-color-scheme: dark)')
    const theme = () => (dark.matches ? 'dark' : 'light')
    const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)').matches
    // The stage measures its host, so that has to be in the page first.
    document.getElementById('replay')?.append(this.element)
    this.element.append(host)
    if (!Stage.supported()) this.element.classList.add('replay-plain')
    this.stage = new Stage(host, { reducedMotion, theme: theme() })
    dark.addEventListener('change', () => this.stage.setTheme(theme()))
    // Paper is white; the picture has to be drawn before it is printed, not in the next frame.
    const repaint = (now: Theme) => {
      this.stage.setTheme(now)
      this.stage.drawAll()
    }
    addEventListener('beforeprint', () => repaint('print'))
    addEventListener('afterprint', () => repaint(theme()))
    this.stage.layout(host.clientWidth > 700 ? '4' : '1')
    this.stage.load(scene, meshes)
    this.stage.frames(NO_FRAMES)
    this.stage.shadows(true)
    this.#trails('recent')
    this.element.prepend(this.#switches(host.clientWidth > 700))
  }

  show(time: number): void {
    this.#run.bodies(time, this.#poses, this.#visible)
    this.stage.show(this.#poses, this.#visible)
    this.stage.collisions(contactsAt(this.#run.contacts ?? [], this.#scene, time))
    this.#time = time
    this.stage.trailWindows(this.#moves.map(moves => pathWindow(this.#path, time, moves)))
  }

  /** A transparent arm as it stands at this time; null for none. */
  ghost(time: number | null): void {
    if (time === null) {
      this.stage.ghost(null)
      return
    }
    const poses = new Float32Array(this.#poses.length)
    this.#run.bodies(time, poses, new Uint8Array(this.#visible.length))
    this.stage.ghost(poses)
  }

  /** World pose in which a body was shown last. */
  pose(body: number): readonly number[] {
    return [...this.#poses.subarray(7 * body, 7 * body + 7)]
  }

  isVisible(body: number): boolean {
    return this.#visible[body] === 1
  }

  #trails(shown: PathShown): void {
    this.#path = shown
    const stations = shown === 'none' ? [] : this.#run.stations
    this.stage.trails(
      stations.map(({ name }) => this.#run.trail('attained', name)),
      [],
    )
    this.show(this.#time)
  }

  #switches(four: boolean): HTMLElement {
    const fit = element('button', { type: 'button' }, words.fitAll)
    fit.addEventListener('click', () => this.stage.home())
    return element(
      'div',
      { class: 'replay-switches' },
      toggle(words.four, four, on => this.stage.layout(on ? '4' : '1')),
      choice(
        words.paths,
        PATHS.map(one => [one, words.pathsShown[one]]),
        shown => this.#trails(shown),
      ),
      toggle(words.frames, false, on => this.stage.frames(on ? FRAMES : NO_FRAMES)),
      fit,
    )
  }
}
