/** What the results of lines hang on: of the text as the language server has it, and of runs. */
import type { RunStatus } from '../wire/messages'

/** How many lines of a document have which result, in words, and what that means. */
export interface ResultCounts {
  readonly children: string
  readonly title: string
}

/** A line on which the robot moves, grips or waits, from 0, and what its result hangs on; empty with errors. */
export interface LineContent {
  readonly line: number
  readonly content: string
}

/** What the results of a program's lines hang on in the newest good run, by document. */
export type RunContents = RunStatus['results']
