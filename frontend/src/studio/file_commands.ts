/** Commands of the File menu: projects, programs, and what is exported of a run. */
import { csvOf } from '../run/csv'
import { fileWords as titles } from '../text/files'
import { words } from '../text/messages'
import type { Add, Grouped } from './command_groups'
import { exportName, programIn } from './document_names'
import { saveFile, saveRun, textFile } from './download'
import type { DialogKind } from './state'
import type { Studio } from './studio'

export function addFile(studio: Studio, group: Grouped): void {
  addProjects(studio, group('File', 'project'))
  addTexts(studio, group('File', 'text'))
  addExports(studio, group('File', 'export'))
  addRights(studio, group('File', 'right'))
}

function addProjects(studio: Studio, add: Add): void {
  const state = () => studio.store.getState()
  const mayEdit = { enabled: () => state().editing && state().connection === 'connected' }
  const ask = (dialog: DialogKind) => () => studio.store.setState({ dialog })
  add('file.newProject', titles.newProject, [], ask('newProject'), mayEdit)
  add('file.openProject', titles.openProject, ['Ctrl+O'], ask('openProject'), mayEdit)
  add('file.recent', titles.recent, [], ask('recent'), {
    enabled: () => mayEdit.enabled() && state().recent.length > 0,
  })
  add('file.newProgram', titles.newProgram, [], ask('newProgram'), mayEdit)
  add('file.fromTasks', titles.fromTasks, [], () =>
    studio.dock?.change(titles.fromTasks, () => studio.dock?.preset('tasks')),
  )
}

function addTexts(studio: Studio, add: Add): void {
  const state = () => studio.store.getState()
  const shown = () => state().documents.find(one => one.name === state().document)
  const unsaved = () => state().documents.filter(one => one.unsaved)
  add('file.save', titles.save, ['Ctrl+S'], () => studio.save(state().document), {
    enabled: () => state().editing && state().document !== '',
  })
  add('file.saveAs', titles.saveAs, ['Ctrl+Shift+S'], () => studio.store.setState({ dialog: 'saveAs' }), {
    enabled: () => state().editing && programIn(state().document, state().programs) !== '',
  })
  add(
    'file.saveAll',
    titles.saveAll,
    ['Ctrl+Alt+S'],
    () => unsaved().forEach(one => void studio.save(one.name)),
    { enabled: () => state().editing && unsaved().length > 0 },
  )
  add('file.revert', titles.revert, [], () => studio.revert(state().document), {
    enabled: () => state().editing && shown()?.unsaved === true,
  })
}

function addExports(studio: Studio, add: Add): void {
  const state = () => studio.store.getState()
  const name = () => exportName(state().project, state().program)
  const finished = {
    enabled: () => state().finished > 0 && !state().told && state().connection === 'connected',
  }
  const keep = (ending: string) => async () => {
    try {
      if (await saveRun(state().finished, ending, name())) return
      studio.notify('error', titles.notKept, titles.notKeptHint)
    } catch {
      studio.notify('error', titles.notFetched)
    }
  }
  add('export.report', titles.report, [], () => void keep('html')(), finished)
  add('export.recording', titles.recording, [], () => void keep('npz')(), finished)
  add('export.inputs', titles.inputs, [], () => void keep('inputs.json')(), finished)
  add('export.code', titles.code, [], () => void keep('icr')(), finished)
  add(
    'export.csv',
    titles.csv,
    [],
    () => studio.run && saveFile(`${name()}.csv`, textFile(csvOf(studio.run), 'text/csv')),
    { enabled: () => studio.run !== null },
  )
  const picture = async () => {
    const image = await studio.picture.stage?.image()
    if (image) saveFile(`${name()}.png`, image)
  }
  add('export.picture', titles.picture, [], () => void picture(), {
    enabled: () => studio.picture.stage != null && state().scene !== null,
  })
}

function addRights(studio: Studio, add: Add): void {
  const state = () => studio.store.getState()
  add('file.takeOver', words.takeOver, [], () => studio.takeOver(), { enabled: () => !state().editing })
  add('file.trust', words.trust.trust, [], () => studio.send({ type: 'trust', trusted: true }), {
    enabled: () => !state().trust.trusted,
  })
  add('file.revoke', words.trust.revoke, [], () => studio.send({ type: 'trust', trusted: false }), {
    enabled: () => state().trust.trusted,
  })
}
