/** `window.__ropsim`: what tests and curious people may ask the page. */
import { isOfTexts } from './run_lines'
import type { Studio } from './studio'

type NamedPoses = Readonly<Record<string, readonly number[]>>

export interface StudioHook {
  readonly seek: (time: number) => void
  readonly time: () => number
  /** World poses that are shown: x y z w qx qy qz by name of the body. */
  readonly poses: () => NamedPoses
  /** The same of the ghost and of the jogged arm; null where there is none. */
  readonly ghost: () => NamedPoses | null
  readonly jogged: () => NamedPoses | null
  /** Names of the bodies that are red, and the marks of collisions in W. */
  readonly colliding: () => unknown
  readonly project: (view: number | string, point: readonly [number, number, number]) => unknown
  readonly stats: () => unknown
  /** Time lines of the plots, in the order in which they were opened. */
  readonly plots: () => readonly unknown[]
  /** What the bars of the timeline say, by the name of their lane. */
  readonly lanes: () => Readonly<Record<string, readonly string[]>>
  readonly state: () => Readonly<Record<string, unknown>>
  /** The newest text of a document. */
  readonly text: (document: string) => string
  readonly command: (id: string) => boolean
  readonly ready: boolean
}

declare global {
  interface Window {
    __ropsim?: StudioHook
  }
}

export function installHook(studio: Studio): void {
  const { cursor, picture, runs, store } = studio
  const named = (poses: Float32Array): NamedPoses => {
    const bodies = store.getState().scene?.bodies ?? []
    return Object.fromEntries(bodies.map((body, at) => [body.name, [...poses.subarray(7 * at, 7 * at + 7)]]))
  }
  window.__ropsim = {
    seek: time => {
      cursor.pause()
      cursor.seek(time)
      picture.update()
      picture.draw()
    },
    time: () => cursor.time,
    poses: () => named(picture.poses),
    ghost: () => picture.ghostPoses && named(picture.ghostPoses),
    jogged: () => picture.joggedPoses && named(picture.joggedPoses),
    colliding: () => {
      const { bodies = [], marks = [] } = picture.stage?.colliding ?? {}
      return { bodies: bodies.map(at => store.getState().scene?.bodies[at]?.name ?? ''), marks }
    },
    project: (view, point) => picture.stage?.project(view, point) ?? null,
    stats: () => picture.stage?.stats() ?? null,
    plots: () => [...studio.plots].map(one => one.timeLine),
    lanes: () =>
      Object.fromEntries(studio.transport.lanes.map(({ name, bars }) => [name, bars.map(bar => bar.text)])),
    state: () => {
      const { status, stale, connection, shown, live, following, editing, ghost, documents } =
        store.getState()
      const { history } = studio.desk.documents
      const isOver = status !== null && status.state !== 'waiting' && status.state !== 'running'
      const settled = isOver && isOfTexts(history.texts(status.versions), studio.desk.now())
      return {
        run: status?.id ?? 0,
        runState: status?.state ?? 'none',
        shown,
        simulated: status?.simulated ?? 0,
        stale,
        told: store.getState().told,
        connection,
        editing,
        live: live?.state ?? 'none',
        following,
        ghost,
        frames: runs.frames,
        latency: runs.latency,
        delivered: studio.desk.delivered,
        /** What the newest run has come to is of the texts as they stand. */
        settled,
        /** That run is the one that is shown. */
        current: settled && status.state === 'done' && status.id === runs.id && !stale,
        unsaved: documents.filter(one => one.unsaved).map(one => one.name),
        duration: studio.run?.duration ?? 0,
        recorded: studio.run?.live === false,
      }
    },
    text: document => studio.text(document),
    command: id => studio.commands.run(id),
    get ready() {
      return document.body.dataset.ready !== undefined
    },
  }
}
