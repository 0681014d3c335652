/** What the help panel can show. */
export const TOPICS = ['keys', 'language', 'cell', 'commands'] as const
export type HelpTopic = (typeof TOPICS)[number]
