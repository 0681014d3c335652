/**
 * What page and server say to each other over `/ws/studio`: JSON texts, told apart by `type`.
 * Binary messages are state frames of a live run (`frame.ts`). `ropsim.studio.messages` is the other side.
 */
import type { Finding } from '../run/run'
import type { Pose, SceneDescription } from '../scene/description'

// ---- page → server --------------------------------------------------------------------------------------

/** First message of a connection. `tab` is a random name that lives as long as the tab. */
export interface Hello {
  readonly type: 'hello'
  readonly tab: string
}

/** New text of a document; the server journals it, then compiles and simulates in the background. */
export interface Edit {
  readonly type: 'edit'
  readonly document: string
  readonly text: string
  /** Counts up in the tab; comes back in `documents`. */
  readonly version: number
}

/** Write a document to its file. `overwrite` also when the file has changed on the disk since it was read. */
export interface Save {
  readonly type: 'save'
  readonly document: string
  readonly overwrite: boolean
}

/** Give up unsaved text and read the file again. */
export interface Revert {
  readonly type: 'revert'
  readonly document: string
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

export interface CancelRun {
  readonly type: 'cancel'
}

/** Start a run in real time whose inputs come from keys. */
export interface LiveStart {
  readonly type: 'live_start'
  readonly program: string
  readonly speed: number
}

/** Pause, go on, change speed, end; ending keeps what was recorded so far. */
export interface LiveControl {
  readonly type: 'live_control'
  readonly action: 'pause' | 'resume' | 'stop'
}

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

/** Move the jogged robot: to joint coordinates, or its TCP to a pose in `frame` nearest to `q`. */
export interface JogJoints {
  readonly type: 'jog_joints'
  readonly id: number
  readonly q: readonly number[]
  readonly tool: string
}

export interface JogTcp {
  readonly type: 'jog_tcp'
  readonly id: number
  /** Where the arm stands now [rad | m]. */
  readonly q: readonly number[]
  readonly tool: string
  /** Target pose of the TCP in W. */
  readonly target: Pose
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
  | TakeOver
  | RunNow
  | CancelRun
  | LiveStart
  | LiveControl
  | LiveSpeed
  | SetSignal
  | ForgetInputs
  | JogJoints
  | JogTcp
  | Trust

// ---- server → page --------------------------------------------------------------------------------------

export interface DocumentState {
  /** Path inside the project, such as `programs/main.task` or `cell.toml`. */
  readonly name: string
  /** URI under which the language server knows it. */
  readonly uri: string
  readonly language: 'task' | 'toml' | 'icr'
  readonly text: string
  /** The last `version` of the editing tab that the server has; 0 for the text of the file. */
  readonly version: number
  /** Differs from its file. */
  readonly unsaved: boolean
  /** The file has changed on the disk since it was read. */
  readonly conflict: boolean
  /** Unsaved text of an earlier session has been brought back. */
  readonly recovered: boolean
}

export interface Welcome {
  readonly type: 'welcome'
  readonly ropsim: string
  readonly project: string
  readonly folder: string
  readonly programs: readonly string[]
  /** The program that runs when none is named. */
  readonly program: string
  readonly documents: readonly DocumentState[]
  /** Whether this tab may edit; one tab at a time does. */
  readonly editing: boolean
  readonly trust: TrustState
}

export interface TrustState {
  readonly trusted: boolean
  /** Files of the project that are code and stay inert until it is trusted. */
  readonly code: readonly string[]
}

export interface TrustChanged extends TrustState {
  readonly type: 'trust'
}

/** The cell as it is drawn; sent on connection and when the cell file changes. Null while it is broken. */
export interface SceneMessage {
  readonly type: 'scene'
  readonly scene: SceneDescription | null
  /** Findings of cell file and geometry. */
  readonly findings: readonly Finding[]
}

/** States of documents after an edit, save, revert or change on the disk (texts only where they are new to the tab). */
export interface Documents {
  readonly type: 'documents'
  readonly documents: readonly (Omit<DocumentState, 'text'> & { readonly text: string | null })[]
}

export interface EditingRight {
  readonly type: 'editing'
  readonly editing: boolean
}

/**
 * How the newest run stands. `done`: its pack is at `/run/<id>.pack`. `refused`: the program has errors, the
 * run before stays and is stale. `failed`: the simulator gave up; `message` says why.
 */
export interface RunStatus {
  readonly type: 'run'
  readonly id: number
  readonly state: 'waiting' | 'running' | 'done' | 'refused' | 'cancelled' | 'failed'
  readonly program: string
  readonly message: string
  /** Errors of compiling, for `refused`. */
  readonly findings: readonly Finding[]
  /** Key presses that the run took as inputs. */
  readonly inputs: number
}

export interface LiveStatus {
  readonly type: 'live'
  readonly state: 'starting' | 'running' | 'paused' | 'over'
  readonly speed: number
  readonly program: string
}

/** Names of the numbers in the state frames that follow. */
export interface LiveLayout {
  readonly type: 'layout'
  readonly channels: readonly {
    readonly name: string
    readonly column: string
    readonly unit: string
    readonly description: string
    readonly group: string
  }[]
  /** Indices of the scene's bodies whose poses are in the frames. */
  readonly bodies: readonly number[]
}

/** From a time on a body rides on another one (or rests in W: parent -1), or is not there. */
export interface Placed {
  readonly type: 'placed'
  readonly time: number
  readonly body: number
  readonly parent: number
  readonly pose: Pose
  readonly visible: boolean
}

/** An input that a key has set, with the simulated time that it was given. */
export interface SignalStamped {
  readonly type: 'stamped'
  readonly name: string
  readonly value: number
  readonly time: number
}

/** Answer to a jog. */
export interface Jogged {
  readonly type: 'jogged'
  readonly id: number
  /** Joint coordinates that were reached; those of the request where the target cannot be reached. */
  readonly q: readonly number[]
  /** Pose of the TCP in W. */
  readonly tcp: Pose
  /** World poses of the bodies of the arm, by index. */
  readonly bodies: readonly { readonly body: number; readonly pose: Pose }[]
  readonly reached: boolean
  /** What limits, reach and singularity have to say, worst first; empty when all is well. */
  readonly words: readonly { readonly level: 'error' | 'warning' | 'info'; readonly text: string }[]
}

/** Something to tell the user. */
export interface Notice {
  readonly type: 'notice'
  readonly level: 'error' | 'warning' | 'info'
  readonly code: string
  readonly text: string
  readonly hint: string
}

export type Message =
  | Welcome
  | TrustChanged
  | SceneMessage
  | Documents
  | EditingRight
  | RunStatus
  | LiveStatus
  | LiveLayout
  | Placed
  | SignalStamped
  | Jogged
  | Notice
