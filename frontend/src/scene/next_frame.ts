/** The next animation frame, with a breath before it where the processor draws. */
import { tier } from './tier'

/**
 * Time for messages and input before a frame [ms]. Where the processor draws, the browser holds the page up until
 * each picture is done; frames asked for without a pause would follow each other and let nothing else in.
 */
const BREATH = 8

/** Call `act` in an animation frame to come; returns what calls it off. */
export function onNextFrame(act: (now: number) => void): () => void {
  let frame = 0
  const ask = () => {
    frame = requestAnimationFrame(act)
  }
  if (tier() !== 'soft') {
    ask()
    return () => cancelAnimationFrame(frame)
  }
  const timer = setTimeout(ask, BREATH)
  return () => {
    clearTimeout(timer)
    cancelAnimationFrame(frame)
  }
}
