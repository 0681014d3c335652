/** Words of the program and problems panels. */
export const words = {
  documents: 'Texts of the project',
  unsaved: 'not saved',
  runBy: (stations: string) => `Runs at ${stations}`,
  save: 'Save',
  simulate: 'Simulate this program',
  simulateTitle: 'The views show the run of another program (Ctrl+Enter)',
  saveTitle: 'Write this text to its file (Ctrl+S)',
  loading: 'The editor is being loaded …',
  failed: (reason: string) =>
    `The editor could not be loaded: ${reason}. Reload the page; typed text is kept.`,
  none: 'This project has no texts.',
  recovered: 'This text was not saved in an earlier session and has been brought back.',
  keep: 'Keep it',
  discard: 'Discard it',
  conflict: 'The file has changed on the disk since this text was read.',
  reload: 'Read the file again',
  overwrite: 'Overwrite the file',
  readOnly: 'Read only: another tab edits this project.',
  stale: 'The text has changed; marks and ghost belong to the last good run.',
  staleShort: 'marks of the last good run',
  problems: (count: number, all: number) =>
    count === all ? `${count} ${count === 1 ? 'problem' : 'problems'}` : `${count} of ${all} problems`,
  title: (count: number) => (count === 0 ? 'Problems' : `Problems (${count})`),
  allWell: 'No problems found',
  noMatch: 'No problem has these words.',
  filter: 'Filter problems',
  severities: { error: 'Error', warning: 'Warning', info: 'Note', hint: 'Hint' },
  at: (line: number) => `line ${line}`,
  time: (seconds: number) => `at ${seconds.toFixed(2)} s`,
  firstTime: (seconds: number) => `first at ${seconds.toFixed(2)} s`,
  count: (times: number) => `× ${times}`,
  countTitle: 'Found this many times on this line; each click goes to the next one',
  next: 'Next problem',
  previous: 'Previous problem',
} as const

export const severityIcons = { error: '✖', warning: '▲', info: '●', hint: '◆' } as const
