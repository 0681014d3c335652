/** Texts of the File menu and of its dialogs. */
export const fileWords = {
  newProject: 'New project …',
  openProject: 'Open project …',
  recent: 'Recent projects …',
  newProgram: 'New program …',
  fromTasks: 'New program from tasks',
  save: 'Save',
  saveAs: 'Save program as …',
  saveAll: 'Save all',
  revert: 'Revert to file',
  report: 'Export report (HTML)',
  recording: 'Export recording (NPZ)',
  inputs: 'Export recorded inputs (JSON)',
  code: 'Export neutral code (ICR)',
  csv: 'Export table (CSV)',
  picture: 'Export picture (PNG)',
  notKept: 'This run is not kept any more.',
  notKeptHint: 'Simulate the program again, then export it.',
  notFetched: 'Nothing was exported: there is no connection to the server.',
  dialog: {
    titles: {
      newProject: 'New project',
      openProject: 'Open project',
      recent: 'Recent projects',
      newProgram: 'New program',
      saveAs: 'Save program as',
    },
    origin: 'Start from',
    examples: 'Examples',
    robots: 'A cell of its own for a robot',
    newFolder: 'Folder of the new project',
    newFolderHint: (beside: string) =>
      `A name, or folders with / between them, is made in ${beside}; a full path goes anywhere.`,
    folder: 'Folder of the project',
    folderHint: 'A full path, or a path beside this project.',
    name: 'Name of the program',
    nameHint: 'Letters, digits, blanks, - and _; the file is programs/NAME.task.',
    kept: 'Unsaved text of this project is kept in its journal and comes back with it.',
    foldersIn: (place: string) => `Folders in ${place}`,
    up: 'up',
    home: 'home folder',
    isProject: 'project',
    noFolders: 'No folders here.',
    fromExample: 'New project …',
    recentList: 'Projects that were open last',
    ok: {
      newProject: 'Make and open',
      openProject: 'Open',
      recent: 'Open',
      newProgram: 'Make',
      saveAs: 'Save',
    },
    cancel: 'Cancel',
  },
} as const

/** What a new program begins with: something that runs. */
export function newProgramText(name: string): string {
  const word = name.replace(/\W+/g, '_').replace(/^(?=\d)/, 'p')
  return `program ${word}\nunits mm, deg, s\n\nmov home\n`
}
