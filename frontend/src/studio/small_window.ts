/** Windows in which not everything has its own place: small ones, and large ones at 200 % zoom. */

/** The style sheets have the same numbers. */
const SMALL = '(max-width: 1100px), (max-height: 660px)'

/** False where nothing is drawn and no window has a size. */
export function isSmallWindow(): boolean {
  return globalThis.matchMedia?.(SMALL).matches ?? false
}
