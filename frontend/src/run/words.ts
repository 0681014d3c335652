/** All texts of the timeline. */
export const words = {
  timeline: 'Timeline',
  time: 'Simulated time',
  play: 'Play',
  pause: 'Pause',
  nextStep: 'Next step of the program',
  previousStep: 'Previous step of the program',
  nextFinding: 'Next finding',
  previousFinding: 'Previous finding',
  loop: 'Repeat',
  loopHint: 'Repeat the run, or the stretch chosen with Shift and drag, or with the keys [ and ]',
  speed: 'Speed',
  speedOf: (speed: number) => `${speed}×`,
  line: (line: number) => `line ${line}`,
  input: (text: string) => `input ${text}`,
  valueText: (time: number, end: number, step: string) =>
    `${time.toFixed(1)} of ${end.toFixed(1)} seconds${step ? `, ${step}` : ''}`,
  reading: (time: number, end: number) => `${time.toFixed(2)} / ${end.toFixed(2)} s`,
} as const
