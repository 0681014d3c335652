/** Words for the marks of results beside the lines of a program. */
export const resultWords = {
  valid: 'The result of this line is that of the text as it stands.',
  pending: 'The result of this line is being computed.',
  stale: 'What is shown of this line belongs to an older text.',
  summary: (valid: number, pending: number, stale: number) =>
    [
      pending + stale === 0 ? `${valid} results valid` : `${valid} valid`,
      ...(pending ? [`${pending} pending`] : []),
      ...(stale ? [`${stale} stale`] : []),
    ].join(', '),
  title: 'Lines whose simulated result is that of the text, is being computed, or belongs to an older text',
  legend: 'Marks beside the lines',
  signs: { valid: 'whole bar', pending: 'dotted bar', stale: 'hollow bar' },
} as const
