/**
 * Messages of the server to a page over `/ws/studio`: JSON texts, distinguished by `type`.
 *
 * Written by `tools/wire_types.py` from `ropsim.studio.wire.messages`: change the records there.
 */
import type { Finding, RunEvent } from '../run/run'
import type { Pose, SceneDescription } from '../scene/description'
import type { WayFacts } from './facts'
import type { ResultFigures } from './result'

/** A text of the project. */
export interface DocumentState {
  /** Path inside the project, such as `programs/main.task` or `cell.toml`. */
  readonly name: string
  /** Of the document at the language server. */
  readonly uri: string
  /** By the ending of its name. */
  readonly language: 'task' | 'toml' | 'icr' | 'prolog'
  /** Null where the tab has it already. */
  readonly text: string | null
  /** The last one of the editing tab that the server has; 0 for the text of the file. */
  readonly version: number
  /** Differs from its file. */
  readonly unsaved: boolean
  /** The file has changed on the disk since it was read. */
  readonly conflict: boolean
  /** Unsaved text of an earlier session has been brought back. */
  readonly recovered: boolean
  /** Names the content of the file on which the text was written; an edit returns it. */
  readonly base: string
}

/** Whether the project folder is trusted, and its files of code. */
export interface TrustState {
  /** Whether code in the project may run. */
  readonly trusted: boolean
  /** Files that are code and stay inert until the project is trusted. */
  readonly code: readonly string[]
}

/** An example from which a project can be made. */
export interface ExampleState {
  readonly name: string
  readonly summary: string
}

/** The project; sent on connection and when documents were added or removed. */
export interface Welcome {
  readonly type: 'welcome'
  /** Version of the server. */
  readonly ropsim: string
  /** Name of the project. */
  readonly project: string
  /** In which it lies. */
  readonly folder: string
  /** Names of its programs. */
  readonly programs: readonly string[]
  /** The one that runs when none is named. */
  readonly program: string
  /** All texts. */
  readonly documents: readonly DocumentState[]
  /** Whether this tab may edit; one tab at a time does. */
  readonly editing: boolean
  /** Of the folder. */
  readonly trust: TrustState
  /** Folders of other projects that were open last, newest first. */
  readonly recent: readonly string[]
  /** From which a project can be made. */
  readonly examples: readonly ExampleState[]
}

/** The user has trusted the folder, or does no more. */
export interface TrustChanged {
  readonly type: 'trust'
  readonly trusted: boolean
  readonly code: readonly string[]
}

/** The scene of the cell; sent on connection and when the cell file changes. */
export interface SceneMessage {
  readonly type: 'scene'
  /** Null while the cell is broken. */
  readonly scene: SceneDescription | null
  /** Of cell file and geometry. */
  readonly findings: readonly Finding[]
}

/** States of documents after an edit, save, revert or change on the disk; texts where new to the tab. */
export interface DocumentsChanged {
  readonly type: 'documents'
  readonly documents: readonly DocumentState[]
}

/** The names of the points in the tables of the project, where it has some, and when they change. */
export interface PointNames {
  readonly type: 'points'
  readonly names: readonly string[]
}

/** Whether the tab may edit. */
export interface EditingRight {
  readonly type: 'editing'
  readonly editing: boolean
}

/**
 * How the newest run stands.
 *
 * `done`: its pack is at `/run/<id>.pack`. `refused`: the program has errors, the run before stays and is
 * stale. `failed`: the simulator gave up; `message` says why.
 */
export interface RunStatus {
  readonly type: 'run'
  /** Number of the run. */
  readonly id: number
  /** How it stands. */
  readonly state: 'waiting' | 'running' | 'done' | 'refused' | 'cancelled' | 'failed'
  /** Its name. */
  readonly program: string
  /** Why there is no run. */
  readonly message: string
  /** Of compiling, and also of planning if `planned`; findings of a finished run are in its pack. */
  readonly findings: readonly Finding[]
  /** Number of key presses that the run took as inputs. */
  readonly inputs: number
  /** Whether planning has come to its end. */
  readonly planned: boolean
  /** The run that was carried out: an earlier one where the texts still say the same; 0 while not known. */
  readonly simulated: number
  /** Of the documents to which lines in findings and run refer. */
  readonly versions: Readonly<Record<string, number>>
  /** `older` where the text has changed while the run went on live: it stays the result. */
  readonly age: 'newest' | 'older'
  /** Keys of the lines of its programs (`ropsim.icr.line_contents`), by document, once it is done. */
  readonly results: Readonly<Record<string, readonly string[]>>
}

/** The collisions of a finished run, once they are checked. */
export interface RunWays {
  readonly type: 'ways'
  /** Its number. */
  readonly run: number
  /** All of the run, instead of the findings in its pack. */
  readonly findings: readonly Finding[]
  /** Its figures, instead of the figures in its pack. */
  readonly result: ResultFigures
  /** Its contacts; null for a cell in which nothing can collide. */
  readonly ways: WayFacts | null
}

/** How a live run stands. */
export interface LiveStatus {
  readonly type: 'live'
  /** Of the run. */
  readonly state: 'starting' | 'running' | 'held' | 'over'
  /** Simulated seconds per second. */
  readonly speed: number
  /** Its name. */
  readonly program: string
  /** Share of the planned speed that is requested, 0 to 1. */
  readonly override: number
}

/** Meaning of one number in the state frames of a live run. */
export interface LiveChannel {
  /** Of the channel. */
  readonly name: string
  /** Of the channel that it is, empty for a channel with one. */
  readonly column: string
  /** SI unit as text. */
  readonly unit: string
  /** Description of the channel. */
  readonly description: string
  /** Heading in lists. */
  readonly group: string
  /** Name of the station or device that it is of; empty for the cell. */
  readonly subject: string
  /** Its value holds between changes, else it is linear. */
  readonly held: boolean
}

/** Program of a station of the cell. */
export interface LiveStation {
  /** Of the station. */
  readonly name: string
  /** Name of its program; empty without one. */
  readonly program: string
  /** Name of the text whose lines its channel `line` counts. */
  readonly source: string
}

/** Names of the numbers in the state frames that follow. */
export interface LiveLayout {
  readonly type: 'layout'
  /** One for each number. */
  readonly channels: readonly LiveChannel[]
  /** Indices of the scene's bodies whose poses are in the frames. */
  readonly bodies: readonly number[]
  /** Of the cell, with their programs. */
  readonly stations: readonly LiveStation[]
}

/** From a time on a body rides on another one, or is not there. */
export interface Placed {
  readonly type: 'placed'
  /** [s]. */
  readonly time: number
  /** Index of the body in the scene. */
  readonly body: number
  /** Index of the body that it rides on; -1 where it rests in W. */
  readonly parent: number
  /** In the frame of the parent. */
  readonly pose: Pose
  /** Whether it is there. */
  readonly visible: boolean
}

/** An input that a key has set, with the simulated time [s] that it was given. */
export interface SignalStamped {
  readonly type: 'stamped'
  readonly name: string
  readonly value: number
  readonly time: number
}

/** Something has happened in a live run. */
export interface Happened {
  readonly type: 'happened'
  /** As packs have it. A running task is sent repeatedly, each time longer. */
  readonly event: RunEvent
}

/** World pose of a body of the jogged arm. */
export interface JogBody {
  readonly body: number
  readonly pose: Pose
}

/** Words on limits, reach or singularity. */
export interface JogWords {
  readonly level: 'error' | 'warning' | 'info'
  readonly text: string
}

/** Answer to a jog. */
export interface Jogged {
  readonly type: 'jogged'
  /** Of the jog. */
  readonly id: number
  /** Joint coordinates that were reached; coordinates of the request if the target cannot be reached. */
  readonly q: readonly number[]
  /** Pose of the TCP in W. */
  readonly tcp: Pose
  /** World poses of the bodies of the arm. */
  readonly bodies: readonly JogBody[]
  /** Whether the arm stands where it was to. */
  readonly reached: boolean
  /** Worst first; empty when all is well. */
  readonly words: readonly JogWords[]
  /** Pose of the TCP as programs write it; empty where there is none. */
  readonly location: string
  /** The same as a point of a task is typed, X Y Z Pitch Roll Yaw [mm, deg]; empty without one. */
  readonly typed: string
}

/** A parameter of a task. */
export interface TaskParameter {
  /** Its name. */
  readonly name: string
  /** `location`, `length`, `int` and so on. */
  readonly kind: string
  /** As typed; empty without one. */
  readonly default: string
  /** That a value may have; empty for a plain number. */
  readonly units: readonly string[]
  /** Whether the state of the cell determines it, instead of the operator. */
  readonly told: boolean
  /** Label for users; its name if it has none. */
  readonly word: string
  /** Remark for users, with the bounds of its value. */
  readonly sentence: string
}

/** A task that may be chosen. */
export interface TaskChoice {
  /** How it is called. */
  readonly name: string
  /** Purpose. */
  readonly doc: string
  /**
   * File of the library that it comes from; `yours` for one of the user's own folder, empty for one of the
   * project.
   */
  readonly group: string
  /** Its preconditions, in words. */
  readonly needs: readonly string[]
  /** In their order. */
  readonly parameters: readonly TaskParameter[]
}

/** Choice for points. */
export interface PlaceChoice {
  /** The list of points to which it belongs; empty for a location of the cell. */
  readonly list: string
  /** Of a location or of a point in the list; empty for the whole list. */
  readonly name: string
  /** Text typed for it. */
  readonly text: string
  /** Points that it stands for. */
  readonly count: number
  /** It is the origin of a frame of the cell. */
  readonly frame: boolean
}

/** Where a part lies; the place is empty if unknown. */
export interface PartPlace {
  readonly part: string
  readonly place: string
}

/** Facts at one time. */
export interface WorldNow {
  /** `open` or `closed`; `none` if the tool has no gripper, empty if unknown. */
  readonly gripper: string
  /** Part in the gripper; empty for none. */
  readonly held: string
  /** That lie somewhere. */
  readonly parts: readonly PartPlace[]
  /** All else in words. */
  readonly others: readonly string[]
}

/** Tasks and places to choose from. */
export interface TaskList {
  readonly type: 'task_list'
  /** Counts how often cell, tasks or lists of points were others. */
  readonly revision: number
  /** Tasks of the library first. */
  readonly tasks: readonly TaskChoice[]
  /** That parameters of tasks may have. */
  readonly kinds: readonly string[]
  /** Locations of the cell, then lists of points with their points. */
  readonly places: readonly PlaceChoice[]
  /** Facts before the first step. */
  readonly begin: WorldNow
  /** Of cell, tasks and lists. */
  readonly findings: readonly Finding[]
  /** Why nothing is known of tasks; empty where it is, and then all else counts. */
  readonly problem: string
}

/** State of a step. */
export interface StepState {
  /** The call that it is, as task text. */
  readonly call: string
  /** Whether it is possible. */
  readonly accepted: boolean
  /** `accepted`, or the reason against it. */
  readonly message: string
  /** Next action. */
  readonly hint: string
  /** Doubts about a possible step; empty for none. */
  readonly warning: string
  /** The parameters determined by the state, with their values. */
  readonly told: readonly PartPlace[]
  /** After it. */
  readonly world: WorldNow
  /** Places in the list of points. */
  readonly points: readonly number[]
}

/** A point of the control program. */
export interface ProgramPoint {
  /** In the program; empty where its step is refused. */
  readonly name: string
  /** X Y Z [mm] Pitch Roll Yaw [deg] in the base frame; null where it has no pose. */
  readonly numbers: readonly [number, number, number, number, number, number] | null
  /** Of the tool in W; null without a point. */
  readonly pose: Pose | null
}

/** Answer to `check_tasks`. */
export interface TasksChecked {
  readonly type: 'tasks_checked'
  /** Of the command. */
  readonly id: number
  /** Of the choices; if it differs from that of the list, request a new list. */
  readonly revision: number
  /** One for each that was sent. */
  readonly steps: readonly StepState[]
  /** Of all steps, each once. */
  readonly points: readonly ProgramPoint[]
  /** The program of the steps that are accepted; empty without one. */
  readonly text: string
  /** Its points that are typed as numbers, as a list of points in a file; empty without one. */
  readonly listed: string
  /** Why there is no answer or no text; empty where there is. */
  readonly problem: string
  /** Omitted checks, as one line; empty for none. */
  readonly unchecked: string
}

/** How long the program of the steps takes, planned without drives. */
export interface TasksEstimated {
  readonly type: 'tasks_estimated'
  /** Of the command that it follows. */
  readonly id: number
  /** Cycle time [s]; null where the program does not come to its end. */
  readonly seconds: number | null
  /** First finding of planning; empty for none. */
  readonly message: string
}

/** The fields of a parameter in the form of a task, as `ropsim.tasks.FormParameter` has them. */
export interface FormParameterFields {
  readonly name: string
  readonly kind: string
  readonly default: string
  readonly word: string
  readonly sentence: string
  readonly bounds: readonly string[]
  readonly called: string
}

/** The fields of a form of a task, as `ropsim.tasks.TaskForm` has them. */
export interface TaskFormFields {
  readonly name: string
  readonly doc: string
  readonly parameters: readonly FormParameterFields[]
  readonly needs: readonly string[]
  readonly effects: readonly string[]
  readonly geometry: readonly string[]
  readonly body: string
}

/** Answer to `open_task_form`. */
export interface TaskFormOpened {
  readonly type: 'task_form'
  /** Name of the task. */
  readonly task: string
  /** Text of the project that has it, or that is to have it where it is of the library. */
  readonly document: string
  /** Its fields; null where a form cannot show it. */
  readonly form: TaskFormFields | null
  /** Why not; empty where it can. */
  readonly problem: string
  /** That parameters may have. */
  readonly kinds: readonly string[]
}

/** Finding on a field. */
export interface FormFault {
  /** `name`, `parameters`, or a property of the clause, such as `pre` or `body`. */
  readonly field: string
  /** Which of several fields, from 0; -1 where it is not known. */
  readonly place: number
  /** `error`, `warning` or `hint`. */
  readonly severity: string
  /** In words. */
  readonly message: string
  /** Next action; empty for none. */
  readonly hint: string
}

/** Answer to `check_task_form`. */
export interface TaskFormChecked {
  readonly type: 'task_form_checked'
  /** Of the command. */
  readonly id: number
  /** The whole text of the document with the form in it; empty where the form is no clause yet. */
  readonly text: string
  /** The clause alone, as in that text. */
  readonly clause: string
  /** Of the fields. */
  readonly faults: readonly FormFault[]
}

/** An executed line with its answer. */
export interface ToldLine {
  /** As typed, several lines where it is a block. */
  readonly line: string
  /** Its outcome. */
  readonly outcome: 'open' | 'moved' | 'answered' | 'refused' | 'over'
  /** Lines of the answer. */
  readonly told: readonly string[]
  /** About it; lines in the text `session` count lines of all commands. */
  readonly findings: readonly Finding[]
  /** Line of that text in which it begins. */
  readonly first: number
  /** Number of the run of all commands, at `/told/<run>.pack`; 0 if it is unchanged. */
  readonly run: number
  /** When the motion of this command begins in that run [s]. */
  readonly since: number
}

/** The dialogue so far; sent to a tab that opens the command line. */
export interface CommandLineState {
  readonly type: 'command_line'
  /** In their order; the oldest ones may be left out. */
  readonly lines: readonly ToldLine[]
  /** How many commands the robot has carried out that were not taken back. */
  readonly commands: number
}

/** A line was carried out or refused. */
export interface LineAnswered {
  readonly type: 'line_answered'
  /** Of the line; 0 for a line of another tab. */
  readonly id: number
  /** With its answer. */
  readonly line: ToldLine
  /** How many commands the robot has carried out that were not taken back. */
  readonly commands: number
}

/** Completions of a line. */
export interface WordsOffered {
  readonly type: 'words_offered'
  /** Of the question. */
  readonly id: number
  /** The incomplete word at the end. */
  readonly begun: string
  /** By name; they begin as that does. */
  readonly words: readonly string[]
}

/** Notice for the user. */
export interface Notice {
  readonly type: 'notice'
  readonly level: 'error' | 'warning' | 'info'
  readonly code: string
  readonly text: string
  readonly hint: string
}

/** Result of a dialog of the page: a new program, a new project, another project. */
export interface Answered {
  readonly type: 'answered'
  /** Why it was not done; none where it was. */
  readonly refusal: Notice | null
}

/** A folder from which one may be chosen. */
export interface FolderState {
  /** Its last part. */
  readonly name: string
  /** All of it. */
  readonly path: string
  /** Whether it is one of a project. */
  readonly project: boolean
}

/** The folders in a place of this machine. */
export interface Folders {
  readonly type: 'folders'
  /** Path; empty if there is none to list. */
  readonly place: string
  /** Of the place; empty if that is not to be listed. */
  readonly parent: string
  /** By name. */
  readonly folders: readonly FolderState[]
}

/** The built-in robots, for which a project can be made, by name. */
export interface Robots {
  readonly type: 'robots'
  readonly names: readonly string[]
}

export type Message =
  | Welcome
  | TrustChanged
  | SceneMessage
  | DocumentsChanged
  | PointNames
  | EditingRight
  | RunStatus
  | RunWays
  | LiveStatus
  | LiveLayout
  | Placed
  | SignalStamped
  | Happened
  | Jogged
  | TaskList
  | TasksChecked
  | TasksEstimated
  | TaskFormOpened
  | TaskFormChecked
  | CommandLineState
  | LineAnswered
  | WordsOffered
  | Notice
  | Answered
  | Folders
  | Robots
