/** What the panels show of the studio and what changes rarely; numbers at 60 Hz never come here. */
import { createStore, type StoreApi } from 'zustand/vanilla'
import type { HelpTopic } from '../help/topics'
import type { SceneDescription } from '../scene/description'
import type { ConnectionState } from '../wire/connection'
import type {
  Folders,
  LiveStatus,
  Notice,
  RunStatus,
  SignalStamped,
  TrustState,
  Welcome,
} from '../wire/messages'
import type { StudioDocument } from './documents'
import type { LineContent, ResultCounts, RunContents } from './line_contents'
import { DEFAULT_LOOK, type Look } from './look'
import type { Problem } from './problems'

/** A line whose pose is drawn as a ghost. */
export interface GhostLine {
  readonly document: string
  readonly line: number
  /** From 1. */
  readonly pass: number
  readonly passes: number
  readonly time: number
}

export interface ShownNotice extends Notice {
  readonly id: number
}

/** What the File menu asks for. */
export type DialogKind = 'newProject' | 'openProject' | 'recent' | 'newProgram' | 'saveAs' | 'endTasks'

/** Whether long lines of texts are broken. */
export type Wrap = 'on' | 'off'

export interface StudioState {
  readonly connection: ConnectionState
  readonly ropsim: string
  readonly project: string
  readonly folder: string
  readonly programs: readonly string[]
  readonly program: string
  readonly documents: readonly StudioDocument[]
  /** The document the editor shows. */
  readonly document: string
  readonly editing: boolean
  readonly trust: TrustState
  readonly problems: readonly Problem[]
  /** Those that the language server does not know. */
  readonly found: readonly Problem[]
  /** How the newest run stands; null before the first. */
  readonly status: RunStatus | null
  /** What the results of lines hang on, of all texts and of the newest good run, by document. */
  readonly lines: Readonly<Record<string, readonly LineContent[]>>
  readonly results: RunContents
  /** Of the document that is shown; null while none of its lines has a result. */
  readonly counts: ResultCounts | null
  /** Counts the runs shown; 0 before the first. */
  readonly shown: number
  /** So many times more has been told of a run that was shown. */
  readonly looked: number
  /** A text differs from those of the shown run, and what it comes to is not known yet. */
  readonly changed: boolean
  /** The shown run was live while a text was changed: it stays the result of the older one until asked. */
  readonly older: boolean
  /** The text has changed since the shown run, and has no good run. */
  readonly stale: boolean
  /** Name of the program whose run is shown; empty before the first and for typed commands. */
  readonly ran: string
  /** The shown run is that of typed commands. */
  readonly told: boolean
  readonly scene: SceneDescription | null
  /** False until the server has said how the cell looks. */
  readonly sceneKnown: boolean
  /** The newest cell file has errors; `scene` is the last good one. */
  readonly cellBroken: boolean
  readonly live: LiveStatus | null
  /** Simulated seconds per second of the live run, as it really goes; null while that is not known. */
  readonly pace: number | null
  /** The cursor stays at the end of the live run. */
  readonly following: boolean
  readonly presses: readonly SignalStamped[]
  readonly ghost: GhostLine | null
  readonly selected: number | null
  readonly look: Look
  readonly wrap: Wrap
  readonly notices: readonly ShownNotice[]
  /** What the help panel shows. */
  readonly help: HelpTopic
  /** The newest run that the server has as files, 0 for none, and the name of its program. */
  readonly finished: number
  readonly finishedProgram: string
  readonly dialog: DialogKind | null
  /** Why what the dialog asked for last was not done. */
  readonly refusal: Notice | null
  /** Folders of the projects that were open last. */
  readonly recent: readonly string[]
  readonly examples: Welcome['examples']
  /** The folders among which the dialog lets choose; null until they are told. */
  /** For which robots a project can be made; empty until asked. */
  readonly robots: readonly string[]
  readonly folders: Folders | null
}

const START: StudioState = {
  connection: 'connecting',
  ropsim: '',
  project: '',
  folder: '',
  programs: [],
  program: '',
  documents: [],
  document: '',
  editing: false,
  trust: { trusted: false, code: [] },
  problems: [],
  found: [],
  status: null,
  lines: {},
  results: {},
  counts: null,
  shown: 0,
  looked: 0,
  changed: false,
  older: false,
  stale: false,
  ran: '',
  told: false,
  scene: null,
  sceneKnown: false,
  cellBroken: false,
  live: null,
  pace: null,
  following: false,
  presses: [],
  ghost: null,
  selected: null,
  look: DEFAULT_LOOK,
  wrap: 'off',
  notices: [],
  help: 'keys',
  finished: 0,
  finishedProgram: '',
  dialog: null,
  refusal: null,
  recent: [],
  examples: [],
  folders: null,
  robots: [],
}

export type StudioStore = StoreApi<StudioState>

export function createStudioStore(): StudioStore {
  return createStore<StudioState>(() => START)
}
