/** Kinds of parameters as an operator reads them. */
import { taskWords } from '../../text/tasks'

/** The kind in words; those that are words already stand for themselves. */
export function kindWords(kind: string): string {
  return (taskWords.kinds as Readonly<Record<string, string>>)[kind] ?? kind
}
