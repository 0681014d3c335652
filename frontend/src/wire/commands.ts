/**
 * Messages of a page to the server over `/ws/studio`: JSON texts, distinguished by `type`.
 *
 * Written by `tools/wire_types.py` from `ropsim.studio.wire.commands`: change the records there.
 */
import type { Pose } from '../scene/description'

/** First message of a connection; `tab` is a random name that lives as long as the tab. */
export interface Hello {
  readonly type: 'hello'
  readonly tab: string
}

/** New text of a document; the server journals it, then compiles and simulates in the background. */
export interface Edit {
  readonly type: 'edit'
  /** Its name. */
  readonly document: string
  /** All of it. */
  readonly text: string
  /** Counts up in the tab; comes back in `documents`. */
  readonly version: number
  /** That of the state on which the text was written; without it, that which the server has. */
  readonly base: string | null
}

/** Write a document to its file; `overwrite` also over a file that has changed since it was read. */
export interface Save {
  readonly type: 'save'
  readonly document: string
  readonly overwrite: boolean
}

/** Discard unsaved text and read the file again. */
export interface Revert {
  readonly type: 'revert'
  readonly document: string
}

/** Make a new `programs/NAME.task`, `.icr` or `kb/NAME.pl` with a text; never over one that is there. */
export interface Create {
  readonly type: 'create'
  /** Its name. */
  readonly document: string
  /** Its content. */
  readonly text: string
  /** Of the program, written to `points/NAME.csv`, unless another list is there; empty for none. */
  readonly points: string
}

/** Write `points/NAME.csv` of a program, over an existing list, as requested. */
export interface KeepPoints {
  readonly type: 'keep_points'
  /** `programs/NAME.task`. */
  readonly program: string
  /** The text of the list. */
  readonly points: string
}

/** Open another project in place of this one; relative paths begin at the parent folder of this one. */
export interface OpenProject {
  readonly type: 'open_project'
  readonly path: string
}

/** List the folders in a place; empty for where projects are. */
export interface ListFolders {
  readonly type: 'list_folders'
  readonly path: string
}

/** Make a project in a new folder, from an example or for a built-in robot, and open it. */
export interface NewProject {
  readonly type: 'new_project'
  /** Of the folder. */
  readonly path: string
  /** From which it is made. */
  readonly example: string
  /** For which it is made; empty for a project from the example. */
  readonly robot: string
}

/** List the robots for which a project can be made. */
export interface ListRobots {
  readonly type: 'list_robots'
}

/** Take the right to edit from another tab. */
export interface TakeOver {
  readonly type: 'take_over'
}

/** Simulate now. Empty program: the cell's. */
export interface RunNow {
  readonly type: 'run'
  readonly program: string
  readonly fidelity: 'dynamic' | 'kinematic'
}

/** Cancel the simulation that is running. */
export interface CancelRun {
  readonly type: 'cancel'
}

/** Start a run in real time whose inputs come from keys; it may be held at its start. */
export interface LiveStart {
  readonly type: 'live_start'
  readonly program: string
  readonly speed: number
  readonly begin: 'running' | 'held'
}

/** Hold a live run on its path, let it go on or make one step, or end it; the recording is kept. */
export interface LiveControl {
  readonly type: 'live_control'
  readonly action: 'hold' | 'continue' | 'step' | 'stop'
}

/** Share of their planned speed at which the motions of the live run are followed, 0 to 1. */
export interface LiveOverride {
  readonly type: 'live_override'
  readonly value: number
}

/** Simulated seconds per second of the live run. */
export interface LiveSpeed {
  readonly type: 'live_speed'
  readonly speed: number
}

/** Set an input of the cell in a live run; the simulator stamps it with simulated time. */
export interface SetSignal {
  readonly type: 'signal'
  readonly name: string
  readonly value: number
}

/** Forget recorded key presses: the next runs take the cell's own signal changes only. */
export interface ForgetInputs {
  readonly type: 'forget_inputs'
}

/** Put the arm of a station at joint coordinates `q` [rad | m]; `id` comes back in `jogged`. */
export interface JogJoints {
  readonly type: 'jog_joints'
  readonly station: string
  readonly q: readonly number[]
  readonly tool: string
  readonly id: number
}

/** Move the TCP of the arm of a station, standing at `q`, to a pose in W; `id` comes back in `jogged`. */
export interface JogTcp {
  readonly type: 'jog_tcp'
  readonly station: string
  readonly q: readonly number[]
  readonly tool: string
  readonly target: Pose
  readonly id: number
}

/** Request tasks and places; answered by `task_list`. */
export interface OpenTasks {
  readonly type: 'open_tasks'
}

/** A typed task. */
export interface TaskStep {
  /** Of the task. */
  readonly name: string
  /** Text typed for each location; blank for none. */
  readonly points: readonly string[]
  /** Text typed for each other parameter, with its unit; blank for none. */
  readonly values: readonly string[]
}

/** Request the states of steps; answered by `tasks_checked`, then possibly by `tasks_estimated`. */
export interface CheckTasks {
  readonly type: 'check_tasks'
  /** Comes back in the answers. */
  readonly id: number
  /** All of them, in their order. */
  readonly steps: readonly TaskStep[]
}

/** Request the form of a task; answered by `task_form`. */
export interface OpenTaskForm {
  readonly type: 'open_task_form'
  readonly task: string
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

/** Request the findings on a form; answered by `task_form_checked`. */
export interface CheckTaskForm {
  readonly type: 'check_task_form'
  /** Comes back. */
  readonly id: number
  /** The text into which it is to be written, `kb/NAME.pl`. */
  readonly document: string
  /** Name of the task there that is changed; empty for a new one. */
  readonly task: string
  /** Its fields. */
  readonly form: TaskFormFields
}

/** Request the dialogue of the command line so far; answered by `command_line`. */
export interface OpenCommandLine {
  readonly type: 'open_command_line'
}

/** Let the robot of the command line carry out a line; answered by `line_answered`. */
export interface TellRobot {
  readonly type: 'tell_robot'
  /** Comes back in the answer. */
  readonly id: number
  /** A statement, of several lines where it is a block, or a word to the command line. */
  readonly line: string
}

/** Request completions of a line of the command line; answered by `words_offered`. */
export interface CompleteLine {
  readonly type: 'complete_line'
  /** Comes back in the answer. */
  readonly id: number
  /** Up to the place where one types. */
  readonly line: string
}

/** Cancel the line that the robot of the command line executes; the robot is unchanged. */
export interface GiveUpLine {
  readonly type: 'give_up_line'
}

/** Let code inside the project folder run, or no more. */
export interface Trust {
  readonly type: 'trust'
  readonly trusted: boolean
}

export type Command =
  | Hello
  | Edit
  | Save
  | Revert
  | Create
  | KeepPoints
  | OpenProject
  | ListFolders
  | NewProject
  | ListRobots
  | TakeOver
  | RunNow
  | CancelRun
  | LiveStart
  | LiveControl
  | LiveOverride
  | LiveSpeed
  | SetSignal
  | ForgetInputs
  | JogJoints
  | JogTcp
  | OpenTasks
  | CheckTasks
  | OpenTaskForm
  | CheckTaskForm
  | OpenCommandLine
  | TellRobot
  | CompleteLine
  | GiveUpLine
  | Trust
