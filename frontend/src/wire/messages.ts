/**
 * What the server says to the page over `/ws/studio`: JSON texts, told apart by `type`.
 * Binary messages are state frames of a live run (`frame.ts`). `ropsim.studio.messages` is the other side.
 */
import type { Finding } from '../run/run'
import type { Pose, SceneDescription } from '../scene/description'

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
  /** Folders of other projects that were open last, newest first. */
  readonly recent: readonly string[]
  /** From which a project can be made. */
  readonly examples: readonly { readonly name: string; readonly summary: string }[]
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
  /** Of compiling, and of planning too where `planned`; those of a finished run are in its pack. */
  readonly findings: readonly Finding[]
  readonly planned: boolean
  /** Key presses that the run took as inputs. */
  readonly inputs: number
  /** The run that was carried out: an earlier one where the texts still say the same; 0 while not known. */
  readonly simulated: number
  /** Versions of the documents to which lines in findings and run refer. */
  readonly versions: Readonly<Record<string, number>>
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

/** A message of the program in a live run. */
export interface Printed {
  readonly type: 'printed'
  readonly time: number
  readonly text: string
  readonly source: string
  /** 0 where it has none. */
  readonly line: number
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
  | Printed
  | Jogged
  | Notice
