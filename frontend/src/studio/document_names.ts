/** Names of texts: a finding names its source as a path, a document by its place in the project. */

export interface Named {
  readonly name: string
}

/** Name of the document that a source means, empty where there is none. */
export function documentOfSource(source: string, documents: readonly Named[]): string {
  const path = source.replaceAll('\\', '/')
  const exact = documents.find(one => one.name === path)
  if (exact) return exact.name
  const ending = documents.find(one => path.endsWith(`/${one.name}`))
  if (ending) return ending.name
  // A bare name is the program of that name.
  return documents.find(one => fileName(one.name) === fileName(path) || stem(one.name) === path)?.name ?? ''
}

/** Whether a document is a text of tasks. */
export function isTaskText(document: string): boolean {
  return document.startsWith('kb/')
}

/** Name of a file without its folders. */
export function fileName(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1)
}

function stem(path: string): string {
  return fileName(path).replace(/\.[^.]*$/, '')
}

/** Name of the program that a document holds, empty where it holds none. */
export function programIn(document: string, programs: readonly string[]): string {
  return document.startsWith('programs/') && programs.includes(stem(document)) ? stem(document) : ''
}

/** Name of a file that is exported: project and program, each once, with what no file name may hold as `-`. */
export function exportName(project: string, program: string): string {
  const names = [...new Set([project, program])].map(one => one.replace(/[^\p{L}\p{N}._-]+/gu, '-'))
  return names.filter(Boolean).join('-') || 'run'
}

/** Name of the station that runs a program, empty where none does. */
export function stationOf(
  stations: readonly { readonly name: string; readonly program: string }[],
  program: string,
): string {
  return stations.find(one => program !== '' && one.program === program)?.name ?? ''
}
