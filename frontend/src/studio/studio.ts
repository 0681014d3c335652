/**
 * The studio of the page, free of any user interface library: connection, texts, run, cursor, picture.
 * Panels read `store` for what changes rarely and `loop.every` or `cursor` for what changes always.
 */
import { Cursor } from '../run/cursor'
import type { Finding, Run } from '../run/run'
import { channelOf } from '../run/station'
import type { Timeline } from '../run/timeline'
import { Transport } from '../run/transport'
import { type Theme, theme } from '../style/scheme'
import { newProgramText } from '../text/files'
import { words } from '../text/messages'
import { type UnitChoice, units } from '../units/choice'
import type { Command } from '../wire/commands'
import { Connection } from '../wire/connection'
import { programWord } from './chosen_step'
import { ChosenTasks } from './chosen_tasks'
import { CommandLine } from './command_line'
import { Commands } from './commands'
import type { Dock } from './dock'
import { isTaskText, programIn, stationOf } from './document_names'
import type { StudioDocument } from './documents'
import { FoundInTexts } from './found_in_texts'
import { Jog } from './jog'
import { LineGhost } from './line_ghost'
import { driveLiveRuns, type LiveOrders } from './live_orders'
import type { Look } from './look'
import { Loop } from './loop'
import { marksOf } from './marks_of_points'
import { Noticeboard } from './noticeboard'
import { keepTheme, keepUnits, keepWrap } from './page_settings'
import type { Pass } from './passes'
import { Picture } from './picture'
import type { Problem } from './problems'
import { Receiver } from './receiver'
import { NOW, RunLines, type Texts } from './run_lines'
import { RunView } from './run_view'
import { Runs, type RunTexts } from './runs'
import { SignalBoard } from './signal_board'
import { createStudioStore, type StudioStore, type Wrap } from './state'
import { ProjectStorage, tabName } from './storage'
import { TaskForms } from './task_forms'
import { type Place, TextDesk } from './text_desk'
import { UndoStack } from './undo'

export type { Place } from './text_desk'

/** What the page tells about a plot: where its time line is drawn, and where its scale has the time [px]. */
export interface ShownPlot {
  readonly timeLine: { readonly drawn: number; readonly scale: number; readonly inside: boolean } | null
}

/** From what a project is made: an example, or a robot where one is named. */
export interface ProjectOrigin {
  readonly example: string
  readonly robot: string
}

/** So long typing in a text of tasks rests before the tasks are asked for anew [ms]. */
const TASKS_REST = 400

export class Studio {
  readonly store: StudioStore = createStudioStore()
  readonly cursor = new Cursor()
  readonly transport = new Transport(this.cursor)
  readonly commands = new Commands()
  readonly undo = new UndoStack()
  readonly picture = new Picture(this.cursor)
  readonly loop: Loop
  readonly desk: TextDesk
  readonly runs: Runs
  readonly view: RunView
  readonly jog: Jog
  readonly live: LiveOrders
  readonly signals: SignalBoard
  readonly tasks: ChosenTasks
  readonly commandLine: CommandLine
  readonly forms = new TaskForms({ send: command => this.send(command) })
  readonly connection: Connection
  readonly lines = new RunLines({
    text: name => this.text(name),
    documentOf: source => this.documentOf(source),
  })
  /** The plots that stand in panels. */
  readonly plots = new Set<ShownPlot>()
  storage = new ProjectStorage('')
  #renewing = 0
  /** From where the run of commands is played that is on its way [s]. */
  #since = 0
  /** Null until the panels stand. */
  dock: Dock | null = null
  /** The timeline that is shown, null until it stands. */
  timeline: Timeline | null = null
  readonly #board = new Noticeboard(this.store)
  readonly #lines: LineGhost
  readonly #found = new FoundInTexts({
    lines: this.lines,
    documentOf: source => this.documentOf(source),
    list: (source, problems) => this.#board.setProblems(source, problems),
  })

  constructor(address: string) {
    const { cursor, picture, store } = this
    const mark = () => this.loop.mark()
    const send = (command: Command) => this.send(command)
    this.loop = new Loop(
      seconds => {
        cursor.advance(seconds)
        return cursor.playing
      },
      () => {
        picture.update()
        picture.draw()
      },
    )
    this.live = driveLiveRuns(store, this.transport, send)
    this.desk = new TextDesk(store, send, text => this.notify('warning', text))
    this.view = new RunView(store, this.transport, picture, this.loop)
    this.#lines = new LineGhost(store, picture, {
      run: () => this.run,
      time: () => cursor.time,
      documentOf: source => this.documentOf(source),
      text: document => this.text(document),
      lines: this.lines,
      mark,
    })
    this.runs = new Runs({
      onRun: (run, of) => this.#showRun(run, of),
      onTold: (run, of) => this.#tellRun(run, of),
      onGrown: run => {
        this.view.grown(run)
        if (store.getState().pace !== this.runs.pace) store.setState({ pace: this.runs.pace })
      },
      onTrouble: text => this.notify('error', words.run.unreadable(text)),
    })
    store.subscribe(({ live }, before) => {
      if (live?.speed === before.live?.speed && live?.state === before.live?.state) return
      this.runs.forgetPace()
      store.setState({ pace: null })
    })
    this.jog = new Jog({ send, show: answer => picture.jogged(answer), undo: this.undo })
    this.jog.onChange(mark)
    this.signals = new SignalBoard(send, store, this.undo)
    this.tasks = new ChosenTasks({
      send,
      show: (points, selected) => {
        picture.points(marksOf(points, selected))
        mark()
      },
      keep: steps => this.storage.write('steps', steps),
      undo: this.undo,
    })
    this.commandLine = new CommandLine({
      send,
      show: (run, since) => this.#showCommands(run, since),
      keep: lines => this.storage.write('commands', lines),
      trouble: text => this.notify('warning', text),
      leave: () => this.dock?.leave('command'),
      undo: this.undo,
    })
    const receiver = new Receiver(this)
    this.connection = new Connection(address, tabName(), {
      onMessage: message => receiver.receive(message),
      onFrame: bytes => this.runs.frame(bytes),
      onState: connection => store.setState({ connection }),
    })
    // The path of a live run grows behind the tool; a whole path in each frame would be too much.
    this.loop.every(2, () => {
      if (this.run?.live) picture.grown()
    })
  }

  start(): void {
    this.connection.open()
  }

  /** Send a command; false while there is no connection. */
  send(command: Command): boolean {
    return this.connection.send(command)
  }

  // ---- texts ----

  get documents(): readonly StudioDocument[] {
    return this.store.getState().documents
  }

  /** The newest text of a document, typed a moment ago or not. */
  text(document: string): string {
    return this.desk.documents.text(document)
  }

  /** New text from the keyboard; it reaches the server within a moment, or after the connection is back. */
  edit(document: string, text: string): void {
    this.desk.edit(document, text)
    this.#edited(document)
  }

  /** New text from a form or a new name: it reaches the server, and an editor takes it over. */
  write(document: string, text: string): void {
    this.desk.write(document, text)
    this.#edited(document)
  }

  #edited(document: string): void {
    this.undo.look()
    this.textsMoved()
    if (isTaskText(document)) this.renewTasks()
  }

  /** A text of tasks has changed: what may be chosen is asked anew, when typing rests. */
  renewTasks(): void {
    window.clearTimeout(this.#renewing)
    this.#renewing = window.setTimeout(() => {
      this.desk.flush()
      this.tasks.renew()
    }, TASKS_REST)
  }

  /** Texts have changed: what stands on their lines moves along. */
  textsMoved(): void {
    this.#found.renew()
    this.#lines.moved()
    this.#compareTexts()
    this.loop.mark()
  }

  /** Mark the result of the shown run as that of another text, or no more: a text may be typed back. */
  #compareTexts(): void {
    const shown = this.run?.live === false
    const changed = shown && this.lines.changed
    this.store.setState({ older: shown && this.lines.isOlder })
    if (changed === this.store.getState().changed) return
    this.store.setState({ changed })
    if (!changed) this.view.setStale('current')
  }

  save(document: string, disk: 'keep' | 'overwrite' = 'keep'): void {
    this.desk.save(document, disk)
  }

  revert(document: string): void {
    this.desk.flush() // an edit on its way must not undo it
    this.send({ type: 'revert', document })
  }

  /** Make a program with the usual head; its name is that of the file. */
  newProgram(name: string): void {
    this.desk.create(`programs/${name}.task`, newProgramText(name))
  }

  /** Keep the text of the shown program under a new name as well; the new one is shown from then on. */
  saveAs(name: string): void {
    const { document } = this.store.getState()
    const ending = /\.[^.]*$/.exec(document)?.[0] ?? '.task'
    const folder = isTaskText(document) ? 'kb' : 'programs'
    this.desk.create(`${folder}/${name}${ending}`, this.text(document))
  }

  /** Make a program of the steps that are accepted and its list of points, and run it; over others only if asked for. */
  makeProgram(name: string, kind: 'new' | 'replace'): void {
    const text = this.tasks.answer?.text.replace(/^program \S+/, `program ${programWord(name)}`) ?? ''
    const points = this.tasks.answer?.listed ?? ''
    const document = `programs/${name}.task`
    const run = () => void this.send({ type: 'run', program: name, fidelity: 'dynamic' })
    if (kind === 'new') {
      this.desk.create(document, text, run, points)
      return
    }
    this.write(document, text)
    this.save(document)
    if (points) this.send({ type: 'keep_points', program: document, points })
    this.store.setState({ document, dialog: null, refusal: null })
    run()
  }

  /** Show the text of the task whose form is open. */
  showTaskText(): void {
    this.store.setState({ document: this.forms.document })
    this.dock?.show('program')
  }

  /** Write the task of the form into its text and save that; it can be chosen at once. */
  keepTask(): void {
    const { document, checked } = this.forms
    if (!checked) return
    if (this.desk.documents.has(document)) {
      this.write(document, checked.text)
      this.save(document)
    } else {
      this.desk.create(document, checked.text)
    }
    this.forms.close()
    this.renewTasks()
  }

  openProject(path: string): void {
    this.desk.flush() // what was typed last belongs into the journal of this project
    this.send({ type: 'open_project', path })
  }

  /** Ask for the folders in a place; empty for where projects are. */
  listFolders(path: string): void {
    this.send({ type: 'list_folders', path })
  }

  /** Ask for which robots a project can be made. */
  listRobots(): void {
    this.send({ type: 'list_robots' })
  }

  newProject(path: string, from: ProjectOrigin): void {
    this.desk.flush()
    this.send({ type: 'new_project', path, ...from })
  }

  takeOver(): void {
    this.send({ type: 'take_over' })
  }

  documentOf(source: string): string {
    return this.desk.documentOf(source)
  }

  /** Show a place in the editor. */
  goTo(document: string, line: number, column = 1): void {
    this.desk.goTo({ document, line, column })
  }

  /** Show a place in the editor, which another panel may hide. */
  showText(document: string, line: number, column: number): void {
    this.dock?.show('program')
    this.goTo(document, line, column)
  }

  /** Show a line of the shown run where it stands in the text of now; nothing where it is gone. */
  goToRun(source: string, line: number): void {
    const place = this.lines.place(source, line)
    if (place) this.goTo(place.document, place.line)
  }

  /** Show a line of the shown run where it stands in the text of now, and run and ghost at a time [s] of it. */
  goToMoment(source: string, line: number, time: number): void {
    const place = this.lines.place(source, line)
    if (place) this.goToFound({ ...place, column: 1 }, time, 'moment')
    else this.transport.go(time)
  }

  /** Show where and when [s] something was found; the ghost stands there at that moment, or at the end of that pass. */
  goToFound({ document, line, column }: Place, time: number, ghost: 'moment' | 'pass'): void {
    this.transport.go(time)
    if (!document) return
    this.goTo(document, line, column)
    if (ghost === 'moment') this.#lines.showAt(document, line, time)
    else this.#lines.show(document, line)
  }

  onGoTo(listener: (place: Place) => void): () => void {
    return this.desk.onGoTo(listener)
  }

  // ---- line and robot ----

  /** What a line did in the shown run, pass by pass. */
  passes(document: string, line: number): readonly Pass[] {
    return this.#lines.passes(document, line)
  }

  /** Draw the robot as a ghost where a line had done its work; pass from 1, else the one nearest to now. */
  showLine(document: string, line: number, pass?: number): void {
    this.#lines.show(document, line, pass)
  }

  clearGhost(): void {
    this.#lines.clear()
  }

  /** The line that runs at the cursor, that of the shown text before others; null where none does. */
  runningLine(): { readonly document: string; readonly line: number } | null {
    const running = this.#lines.running()
    const { document } = this.store.getState()
    return running.find(one => one.document === document) ?? running[0] ?? null
  }

  // ---- findings and notices ----

  get problems(): readonly Problem[] {
    return this.store.getState().problems
  }

  /** All findings of the language server, and the documents that it has checked. */
  setChecked(problems: readonly Problem[], documents: ReadonlySet<string>): void {
    this.#board.setProblems('lsp', problems)
    this.#found.setChecked(documents)
  }

  /** Findings of one source (`run`, `scene`, …), which belong to texts of a moment; they replace its earlier ones. */
  setFindings(source: string, findings: readonly Finding[], texts: Texts = NOW): void {
    this.#found.set(source, findings, texts)
  }

  notify(level: 'error' | 'warning' | 'info', text: string, hint = '', code = ''): void {
    this.#board.notify(level, text, hint, code)
  }

  dismiss(id: number): void {
    this.#board.dismiss(id)
  }

  // ---- run and picture ----

  get run(): Run | null {
    return this.runs.run
  }

  get stale(): boolean {
    return this.store.getState().stale
  }

  /** Show the newest run of the program in place of that of commands. */
  showProgramRun(): void {
    const { status, finished, finishedProgram } = this.store.getState()
    if (finished === 0) return
    const texts = this.desk.documents.history.texts(status?.id === finished ? status.versions : {})
    void this.runs.take(finished, texts, status?.id === finished ? status.age : 'newest', finishedProgram)
  }

  /** Show the run of all commands, and play it from where the motion of the last one begins [s]. */
  #showCommands(run: number, since: number): void {
    this.#since = since
    void this.runs.takeCommands(run)
  }

  /** Keep the cursor at the end of the live run. */
  follow(): void {
    this.store.setState({ following: true })
    if (this.run) this.view.grown(this.run)
  }

  /** Take the robot of a station where the run shows it and jog it from there. */
  jogFromRun(station = this.stationInSight()): void {
    const joints = this.store.getState().scene?.stations.find(one => one.name === station)?.joints
    if (!joints) return
    const channel = channelOf('q', station)
    const shown = joints.map((_, at) => this.run?.value(channel, at, this.cursor.time) ?? 0)
    this.jog.start(station, shown.every(Number.isFinite) ? shown : joints.map(() => 0))
  }

  /** Take the robot where the run shows it, and show the panel that moves it. */
  jogInSight(): void {
    this.jogFromRun()
    this.dock?.show('jog')
  }

  /** The station that is jogged, else the one whose program is open, else the first one. */
  stationInSight(): string {
    const { scene, document, programs } = this.store.getState()
    const stations = scene?.stations ?? []
    const name = this.jog.q ? this.jog.station : stationOf(stations, programIn(document, programs))
    return (stations.find(one => one.name === name) ?? stations[0])?.name ?? ''
  }

  /** Highlight a body of the scene, or none. */
  select(selected: number | null): void {
    this.store.setState({ selected })
    this.picture.stage?.select(selected)
    this.loop.mark()
  }

  /** The next runs take the cell's own signal changes only. */
  forgetPresses(): void {
    this.send({ type: 'forget_inputs' })
    this.store.setState({ presses: [] })
  }

  /** Look at the cell in another way; with a name it can be undone. */
  setLook(change: Partial<Look>, name?: string): void {
    const before = this.store.getState().look
    const after = { ...before, ...change }
    if (name) this.undo.do({ name, undo: () => this.#apply(before), redo: () => this.#apply(after) })
    else this.#apply(after)
  }

  /** Show the page light or dark; with a way back. */
  chooseTheme(next: Theme, name: string): void {
    const before = theme()
    this.undo.do({ name, undo: () => keepTheme(before), redo: () => keepTheme(next) })
  }

  /** Show numbers in other units; with a way back. */
  chooseUnits(next: UnitChoice, name: string): void {
    const before = units()
    const apply = (choice: UnitChoice) => {
      keepUnits(choice)
      this.loop.mark()
    }
    this.undo.do({ name, undo: () => apply(before), redo: () => apply(next) })
  }

  /** Break long lines of texts, or let them run out of sight; with a way back. */
  chooseWrap(next: Wrap, name: string): void {
    const before = this.store.getState().wrap
    const apply = (wrap: Wrap) => {
      keepWrap(wrap)
      this.store.setState({ wrap })
    }
    this.undo.do({ name, undo: () => apply(before), redo: () => apply(next) })
  }

  #apply(look: Look): void {
    this.store.setState({ look })
    this.storage.write('look', look)
    this.picture.setLook(look)
    this.loop.mark()
  }

  #showRun(run: Run, { texts, age, program, of }: RunTexts): void {
    this.store.setState({ told: of === 'commands', ran: program })
    this.lines.showRun(texts, age)
    this.view.show(run)
    if (of === 'commands') {
      // What was found stands below the lines; what is listed stays that of the program.
      this.view.setStale('current')
      this.#compareTexts()
      this.cursor.setLoop(null)
      this.cursor.seek(this.#since)
      if (this.#since < run.duration) this.cursor.play()
      return
    }
    this.setFindings('compile', [])
    this.setFindings('run', run.findings, texts)
    this.#lines.renew()
    this.#compareTexts()
  }

  /** More of the shown run has been looked at; where it is, and which text is shown, stays. */
  #tellRun(run: Run, { texts }: RunTexts): void {
    this.transport.show(run)
    this.store.setState({ looked: this.store.getState().looked + 1 })
    this.setFindings('run', run.findings, texts)
  }
}
