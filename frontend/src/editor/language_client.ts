/** The language server in the editor: marks after 30 ms, completion, hover, names, calls, actions. */
import {
  hoverTooltips,
  LSPClient,
  LSPPlugin,
  serverCompletionSource,
  signatureHelp,
} from '@codemirror/lsp-client'
import { type EditorView, keymap, ViewPlugin, type ViewUpdate } from '@codemirror/view'
import type { LineContent } from '../studio/line_contents'
import type { Problem } from '../studio/problems'
import { actionsPanel } from './actions_panel'
import { completions } from './completions'
import { EDIT_KEYS } from './edit_actions'
import { marksOf, type Published, problemsOf } from './findings'
import { foundMarks } from './found_marks'
import { sameName } from './same_name'
import { sanitizeHTML } from './sanitize'
import { changedText } from './server_edits'
import { putMarks } from './shown_marks'
import { LanguageLink } from './transport'
import { type OpenedDocument, ProjectWorkspace } from './workspace'

/** Pause after a keystroke before it is sent [ms]. */
const PAUSE = 30

/** What the server says of the lines of a document. */
interface LineStates {
  readonly uri: string
  readonly version: number
  readonly lines: readonly LineContent[]
}

/** Answers may take any time: a lost connection ends waiting, a clock does not. */
const NO_TIMEOUT = 2 ** 31 - 1

const soon = ViewPlugin.fromClass(
  class {
    #timer: ReturnType<typeof setTimeout> | undefined

    constructor(readonly view: EditorView) {}

    update(update: ViewUpdate): void {
      if (!update.docChanged) return
      clearTimeout(this.#timer)
      this.#timer = setTimeout(() => LSPPlugin.get(this.view)?.client.sync(), PAUSE)
    }

    destroy(): void {
      clearTimeout(this.#timer)
    }
  },
)

/** Who hears of what the language server says. */
export interface LanguageEvents {
  /** All findings, and the documents that were checked, at every change. */
  readonly onProblems: (problems: readonly Problem[], documents: ReadonlySet<string>) => void
  /** What the results of the lines of a document hang on, at every change. */
  readonly onLines: (document: string, lines: readonly LineContent[]) => void
  /** Puts a document into the view, for definitions in other files. */
  readonly onShow: (document: string) => Promise<EditorView | null>
  /** Changes a document that no view shows. */
  readonly onWrite: (document: string, change: (text: string) => string) => void
}

export class LanguageClient {
  readonly #client: LSPClient
  readonly #link: LanguageLink
  readonly #events: LanguageEvents
  readonly #published = new Map<string, Published>()
  #names: ReadonlyMap<string, string> = new Map()
  #found: readonly Problem[] = []

  /** @param address of the language server's socket */
  constructor(address: string, events: LanguageEvents) {
    this.#events = events
    this.#client = new LSPClient({
      timeout: NO_TIMEOUT,
      sanitizeHTML,
      workspace: client => {
        const workspace = new ProjectWorkspace(client)
        workspace.displayFile = uri => events.onShow(this.#names.get(uri) ?? '')
        workspace.write = (uri, change) =>
          events.onWrite(this.#names.get(uri) ?? '', text => changedText(text, change))
        return workspace
      },
      notificationHandlers: {
        'textDocument/publishDiagnostics': (_, params: Published) => {
          this.#take(params)
          return true
        },
        'ropsim/lineStates': (_, params: LineStates) => {
          this.#takeLines(params)
          return true
        },
      },
      extensions: [
        soon,
        completions(serverCompletionSource),
        hoverTooltips({ hoverTime: 300 }),
        signatureHelp({ keymap: false }),
        sameName,
        actionsPanel,
        keymap.of(EDIT_KEYS),
        { clientCapabilities: { experimental: { ropsimLineStates: true } } },
      ],
    })
    this.#link = new LanguageLink(address, {
      onReady: transport => this.#client.connect(transport),
      onLost: () => this.#client.disconnect(),
    })
    this.#link.open()
  }

  extension(document: OpenedDocument) {
    return this.#client.plugin(document.uri, document.language)
  }

  /** Let the server know all documents of the project. */
  keep(documents: readonly OpenedDocument[]): void {
    this.#names = new Map(documents.map(one => [one.uri, one.name]))
    for (const uri of this.#published.keys()) {
      if (!this.#names.has(uri)) this.#published.delete(uri)
    }
    this.#workspace.keep(documents)
    this.#tell()
  }

  /** Send what was typed, now. */
  sync(): void {
    this.#client.sync()
  }

  /** Show what is known about the document that a view has just been given. */
  showKnown(view: EditorView): void {
    const plugin = LSPPlugin.get(view)
    const known = plugin && this.#published.get(plugin.uri)
    const marks = known ? marksOf(known.diagnostics, view.state.doc, at => at) : []
    putMarks(view, [...marks, ...foundMarks(this.#found, view.state.doc)])
  }

  /** What runs have found in the document that is shown, for the marks that follow. */
  setFound(problems: readonly Problem[]): void {
    this.#found = problems
  }

  destroy(): void {
    this.#link.close()
  }

  get #workspace(): ProjectWorkspace {
    return this.#client.workspace as ProjectWorkspace
  }

  #take(published: Published): void {
    const file = this.#workspace.getFile(published.uri)
    if (file && published.version !== undefined && published.version !== file.version) return
    this.#published.set(published.uri, published)
    const view = file?.getView()
    const plugin = view && LSPPlugin.get(view)
    if (view && plugin) {
      const map = (at: number) => plugin.unsyncedChanges.mapPos(at)
      const marks = marksOf(published.diagnostics, plugin.syncedDoc, map)
      putMarks(view, [...marks, ...foundMarks(this.#found, view.state.doc)])
    }
    this.#tell()
  }

  #takeLines({ uri, version, lines }: LineStates): void {
    const name = this.#names.get(uri)
    if (name !== undefined && this.#workspace.getFile(uri)?.version === version)
      this.#events.onLines(name, lines)
  }

  #tell(): void {
    const checked = new Set<string>()
    const problems = [...this.#published].flatMap(([uri, { diagnostics }]) => {
      const name = this.#names.get(uri)
      if (name === undefined) return []
      checked.add(name)
      return problemsOf(diagnostics, name)
    })
    this.#events.onProblems(problems, checked)
  }
}
