/** Texts of the strip that tells the result of a run. */
export const resultWords = {
  strip: 'Result of the run',
  live: 'live',
  liveLong: 'A live run is in progress: its result appears when it ends.',
  none: 'No result yet.',
  stale: 'last valid run',
  older: 'live run of the older text',
  changed: 'before the change of the text',
  runOf: (program: string) => `run of ${program}`,
  markOf: (mark: string, program: string) => `${mark}, of ${program}`,
  signs: { good: '✔', doubtful: '▲', failed: '✖' },
  spoken: { good: 'Good', doubtful: 'Doubtful', failed: 'Failed' },
  cycle: 'Cycle time',
  notValid: 'not that of the program',
  settling: 'Settling',
  ofCycle: (share: string) => `${share} of the cycle`,
  ofCycles: (share: string) => `${share} of the stations' cycles together`,
  torque: 'Peak torque',
  notSimulated: 'not simulated',
  withoutDrives: 'without drives',
  limitUnknown: 'limit unknown',
  limit: 'Smallest joint margin',
  side: (joint: string, side: 'lower' | 'upper') => `${joint}, ${side} limit`,
  path: 'Largest path error of tool paths',
  noPath: 'no tool paths',
  line: (line: number) => (line > 0 ? `line ${line}` : ''),
  parts: 'Parts at their destinations',
  reached: (reached: number, wanted: number) => `${reached} of ${wanted}`,
  away: (count: number) => `${count} elsewhere`,
  findings: 'Findings',
  counts: (errors: number, warnings: number, hints: number) =>
    errors + warnings + hints === 0
      ? 'no problems found'
      : [
          errors ? `${errors} ${errors === 1 ? 'error' : 'errors'}` : '',
          warnings ? `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}` : '',
          hints ? `${hints} ${hints === 1 ? 'hint' : 'hints'}` : '',
        ]
          .filter(Boolean)
          .join(', '),
  go: (label: string, value: string, detail: string) =>
    `${label}: ${value}${detail ? `, ${detail}` : ''}. Go to where it arises`,
} as const
