/** Titles of what can be done in the text editor. */
export const editWords = {
  find: 'Find …',
  replace: 'Find and replace …',
  goToLine: 'Go to line …',
  definition: 'Go to the definition',
  references: 'All places of the name',
  rename: 'Rename …',
  signature: 'Parameters of the task',
  fix: 'Quick fix …',
  comment: 'Comment or uncomment lines',
  format: 'Format the text',
} as const
