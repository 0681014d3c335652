/** What each message of the server means for the studio. */
import type { Cursor } from '../run/cursor'
import type { Finding, Run } from '../run/run'
import { words } from '../text/messages'
import type {
  DocumentState,
  LiveStatus,
  Message,
  Notice,
  RunStatus,
  SceneMessage,
  Welcome,
} from '../wire/messages'
import type { ChosenTasks } from './chosen_tasks'
import type { CommandLine } from './command_line'
import { isTaskText } from './document_names'
import type { Jog } from './jog'
import { type Look, lookFrom } from './look'
import type { Loop } from './loop'
import type { Picture } from './picture'
import { isOfTexts, type RunLines, type Texts } from './run_lines'
import type { RunView } from './run_view'
import type { Runs } from './runs'
import type { SignalBoard } from './signal_board'
import { isSmallWindow } from './small_window'
import type { StudioStore } from './state'
import { ProjectStorage } from './storage'
import type { TaskForms } from './task_forms'
import type { TextDesk } from './text_desk'

/** What messages change. */
export interface Receiving {
  storage: ProjectStorage
  readonly store: StudioStore
  readonly cursor: Cursor
  readonly desk: TextDesk
  readonly jog: Jog
  readonly lines: RunLines
  readonly loop: Loop
  readonly picture: Picture
  readonly run: Run | null
  readonly runs: Runs
  readonly signals: SignalBoard
  readonly tasks: ChosenTasks
  readonly forms: TaskForms
  readonly commandLine: CommandLine
  readonly view: RunView
  renewTasks(): void
  notify(level: 'error' | 'warning' | 'info', text: string, hint?: string, code?: string): void
  select(body: number | null): void
  setFindings(source: string, findings: readonly Finding[], texts?: Texts): void
  setLook(change: Partial<Look>): void
  textsMoved(): void
}

type Handlers = { readonly [T in Message['type']]: (message: Extract<Message, { type: T }>) => void }

export class Receiver {
  readonly #studio: Receiving
  #folder: string | null = null
  /** Texts of an earlier session that this page knows of. */
  #recovered: ReadonlySet<string> = new Set()

  readonly #handlers: Handlers

  constructor(studio: Receiving) {
    this.#studio = studio
    this.#handlers = this.#makeHandlers()
  }

  receive(message: Message): void {
    const handle = this.#handlers[message.type] as ((message: Message) => void) | undefined
    // A newer server may say more than this page knows.
    handle?.(message)
  }

  #makeHandlers(): Handlers {
    const studio = this.#studio
    return {
      welcome: message => this.#welcome(message),
      documents: ({ documents }) => {
        studio.desk.documents.update(documents)
        studio.desk.sync()
        studio.textsMoved()
        // What was reverted, or has changed on the disk, says other tasks.
        if (documents.some(one => one.text !== null && isTaskText(one.name))) studio.renewTasks()
      },
      editing: ({ editing }) => {
        studio.store.setState({ editing })
        studio.desk.flush()
      },
      trust: ({ trusted, code }) => studio.store.setState({ trust: { trusted, code } }),
      scene: message => this.#scene(message),
      run: message => this.#run(message),
      ways: message => studio.runs.see(message),
      live: message => this.#live(message),
      layout: message => this.#layout(message),
      placed: message => studio.runs.place(message),
      stamped: message => {
        studio.runs.stamp(message)
        studio.store.setState({ presses: [...studio.store.getState().presses.slice(-499), message] })
      },
      happened: message => {
        studio.runs.happen(message)
        studio.loop.mark()
      },
      jogged: message => studio.jog.receive(message),
      task_list: message => studio.tasks.receiveList(message),
      tasks_checked: message => studio.tasks.receive(message),
      task_form: message => studio.forms.receive(message),
      task_form_checked: message => studio.forms.receiveChecked(message),
      tasks_estimated: message => studio.tasks.receiveEstimate(message),
      command_line: message => studio.commandLine.receiveState(message),
      line_answered: message => studio.commandLine.receive(message),
      words_offered: message => studio.commandLine.receiveWords(message),
      notice: ({ level, text, hint, code }) => studio.notify(level, text, hint, code),
      points: ({ names }) => studio.desk.setPoints(names),
      robots: ({ names }) => studio.store.setState({ robots: names }),
      folders: folders => studio.store.setState({ folders }),
      answered: ({ refusal }) => this.#answered(refusal),
    }
  }

  /** A dialog that was refused stays open, with the reason and with what was typed. */
  #answered(refusal: Notice | null): void {
    const { store } = this.#studio
    if (!refusal) store.setState({ dialog: null, refusal: null })
    else if (store.getState().dialog) store.setState({ refusal })
    else this.#studio.notify(refusal.level, refusal.text, refusal.hint, refusal.code)
  }

  #welcome(message: Welcome): void {
    const studio = this.#studio
    if (this.#folder !== null && this.#folder !== message.folder) {
      // Another project has taken the place of this one: nothing of the page belongs to it.
      location.reload()
      return
    }
    if (this.#folder !== message.folder) {
      studio.storage = new ProjectStorage(message.folder)
      studio.setLook(lookFrom(studio.storage.read('look'), isSmallWindow() ? '1' : '4'))
    }
    this.#folder = message.folder
    const { ropsim, project, folder, programs, program, editing, trust, recent, examples } = message
    studio.desk.documents.welcome(message.documents)
    // What there is of a live run is told anew after this.
    const over = { live: null, following: false }
    studio.store.setState({
      ropsim,
      project,
      folder,
      programs,
      program,
      editing,
      trust,
      recent,
      examples,
      ...over,
    })
    const first = message.documents.find(one => one.name.includes(`/${program}.`)) ?? message.documents[0]
    if (!studio.store.getState().document) studio.store.setState({ document: first?.name ?? '' })
    studio.desk.sync()
    studio.desk.showWanted()
    studio.desk.flush()
    studio.jog.reconnected()
    studio.tasks.renew()
    studio.commandLine.reconnected()
    this.#reportRecovered(message.documents)
  }

  /** Report texts of an earlier session once; all that are not saved are named, typed in since or not. */
  #reportRecovered(documents: readonly DocumentState[]): void {
    const recovered = documents.filter(one => one.recovered).map(one => one.name)
    const isNews = recovered.some(name => !this.#recovered.has(name))
    this.#recovered = new Set(recovered)
    if (!isNews) return
    const unsaved = documents.filter(one => one.unsaved || one.recovered).map(one => one.name)
    this.#studio.notify('warning', words.recovered(unsaved), words.recoveredHint)
  }

  #scene({ scene, findings }: SceneMessage): void {
    const studio = this.#studio
    studio.setFindings('scene', findings)
    studio.store.setState({ sceneKnown: true, cellBroken: scene === null })
    studio.tasks.renew()
    // A broken cell keeps the picture of the last good one.
    if (!scene) return
    const { scene: before, selected } = studio.store.getState()
    const name = selected === null ? undefined : before?.bodies[selected]?.name
    const still = scene.bodies.findIndex(body => body.name === name)
    studio.store.setState({ scene })
    studio.runs.setScene(scene)
    studio.picture.setScene(scene)
    // The selected body may stand at another place in the edited cell, or be gone.
    studio.select(still < 0 ? null : still)
    studio.jog.setStations(scene.stations)
    studio.signals.setSignals(scene.signals, studio.storage)
    studio.loop.mark()
  }

  #run(status: RunStatus): void {
    const studio = this.#studio
    studio.store.setState({ status, program: status.program || studio.store.getState().program })
    const texts = studio.desk.documents.history.texts(status.versions)
    // Findings of the run before stay until new ones are there, also beside the errors of a text that is refused;
    // those of a finished run come with it.
    if (status.state !== 'done') studio.setFindings('compile', status.findings, texts)
    if (status.planned) studio.setFindings('run', [])
    if (status.state === 'done') {
      const finishedProgram = status.program
      studio.store.setState({ finished: status.id, finishedProgram, results: status.results })
    }
    if (status.state === 'done') void studio.runs.take(status.id, texts, status.age, status.program)
    const { run } = studio
    // What is said of a text that has been typed back meanwhile is no news.
    const now = studio.desk.now()
    const isBack = studio.lines.isOf(now) && !isOfTexts(texts, now)
    const { told } = studio.store.getState()
    if (run && !told && !isBack && ['refused', 'failed'].includes(status.state)) studio.view.setStale('stale')
    if (status.state === 'failed') studio.notify('error', words.run.failed(status.message))
  }

  #live(live: LiveStatus): void {
    const studio = this.#studio
    if (live.state === 'starting') studio.store.setState({ presses: [] })
    studio.store.setState({ live })
    if (live.state !== 'over') return
    studio.signals.disarm()
    studio.store.setState({ following: false })
  }

  #layout(message: Extract<Message, { type: 'layout' }>): void {
    const studio = this.#studio
    studio.cursor.pause()
    studio.cursor.setLoop(null)
    studio.runs.startLive(message, studio.desk.now(), studio.store.getState().live?.program)
  }
}
