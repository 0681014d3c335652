/**
 * All documents of the project as the language server knows them: also those that no view shows, so that an
 * unsaved cell file counts for its programs and every finding is listed.
 */
import { LSPPlugin, Workspace, type WorkspaceFile } from '@codemirror/lsp-client'
import { type ChangeSet, Text } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'

export interface OpenedDocument {
  readonly name: string
  readonly uri: string
  readonly language: string
  readonly text: string
}

class OpenFile implements WorkspaceFile {
  version = 0
  view: EditorView | null = null

  constructor(
    readonly uri: string,
    readonly languageId: string,
    public doc: Text,
  ) {}

  getView(): EditorView | null {
    return this.view
  }
}

export function textOf(text: string): Text {
  return Text.of(text.split(/\r\n|\n|\r/))
}

export class ProjectWorkspace extends Workspace {
  files: OpenFile[] = []
  /** Writes a document that no view shows. */
  write: (uri: string, change: ChangeSet) => void = () => {}

  /** All texts as they are now, by their addresses. */
  get texts(): ReadonlyMap<string, Text> {
    return new Map(this.files.map(({ uri, view, doc }) => [uri, view?.state.doc ?? doc]))
  }

  /** Change a document, in its view where it is shown. */
  change(uri: string, change: ChangeSet): void {
    const view = this.#file(uri)?.view
    if (view) view.dispatch({ changes: change, userEvent: 'rename' })
    else this.write(uri, change)
  }

  /** Let the server have these documents and no others; shown ones are left to their views. */
  keep(documents: readonly OpenedDocument[]): void {
    const uris = new Set(documents.map(one => one.uri))
    for (const file of this.files) {
      if (!uris.has(file.uri) && !file.view) this.client.didClose(file.uri)
    }
    this.files = this.files.filter(file => uris.has(file.uri) || file.view)
    for (const one of documents) {
      const file = this.#file(one.uri)
      if (!file) this.#open(new OpenFile(one.uri, one.language, textOf(one.text)))
      else if (!file.view) this.#replace(file, textOf(one.text))
    }
  }

  override syncFiles() {
    const updates = []
    for (const file of this.files) {
      const plugin = file.view && LSPPlugin.get(file.view)
      if (!plugin || plugin.unsyncedChanges.empty) continue
      const changes = plugin.unsyncedChanges
      const prevDoc = file.doc
      file.doc = plugin.view.state.doc
      file.version += 1
      plugin.clear()
      updates.push({ file, prevDoc, changes })
    }
    return updates
  }

  override openFile(uri: string, languageId: string, view: EditorView): void {
    const file = this.#file(uri)
    if (file) {
      file.view = view
      this.#replace(file, view.state.doc)
    } else {
      const opened = new OpenFile(uri, languageId, view.state.doc)
      opened.view = view
      this.#open(opened)
    }
  }

  override closeFile(uri: string, view: EditorView): void {
    const file = this.#file(uri)
    if (file?.view === view) file.view = null
  }

  override getFile(uri: string): OpenFile | null {
    return this.#file(uri)
  }

  #file(uri: string): OpenFile | null {
    return this.files.find(file => file.uri === uri) ?? null
  }

  #open(file: OpenFile): void {
    this.files.push(file)
    this.client.didOpen(file)
  }

  #replace(file: OpenFile, doc: Text): void {
    if (file.doc.eq(doc)) return
    file.doc = doc
    file.version += 1
    this.client.notification('textDocument/didChange', {
      textDocument: { uri: file.uri, version: file.version },
      contentChanges: [{ text: doc.toString() }],
    })
  }
}
