/** A camera's way from one pose to another. */
import { between } from './camera_pose'
import type { CameraPose } from './settings'

/** [ms] */
const DURATION = 220

export class Glide {
  #start = Number.NaN

  constructor(
    private readonly from: CameraPose,
    private readonly to: CameraPose,
  ) {}

  /** Where the camera is at a time [ms] of the page; `over` when it has arrived. */
  at(now: number): { readonly pose: CameraPose; readonly over: boolean } {
    if (Number.isNaN(this.#start)) this.#start = now
    const share = Math.min(1, (now - this.#start) / DURATION)
    if (share >= 1) return { pose: this.to, over: true }
    return { pose: between(this.from, this.to, share * share * (3 - 2 * share)), over: false }
  }
}
