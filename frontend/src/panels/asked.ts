/** What a value in the jog panel was asked to be. */

/** What was typed last, so that a refusal can be told beside it. */
export interface Asked {
  /** Name of the joint or direction; empty for none. */
  readonly name: string
  /** [m | rad] */
  readonly value: number
  /** What the kinematics had to say about it. */
  readonly why: string
  readonly set: (name: string, value: number) => void
  readonly forget: () => void
  /** The same, and what is said of it is said no more. */
  readonly giveUp: () => void
}
