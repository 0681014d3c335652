/** Switches that leave the keyboard to commands once a pointer has used them. */

/** What is needed of a click. */
export interface SwitchClick {
  /** Clicks of a pointer so far; none where a key has pressed the switch. */
  readonly detail: number
  readonly currentTarget: { readonly blur: () => void }
}

/** Give up the focus after a click of a pointer, so that Space plays and pauses; who uses keys keeps it. */
export function letGo({ detail, currentTarget }: SwitchClick): void {
  if (detail > 0) currentTarget.blur()
}
