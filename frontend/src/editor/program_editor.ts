/** The text editor of the studio: one view, one history per document, marks of the run and of the compiler. */
import { history, redo, undo } from '@codemirror/commands'
import { bracketMatching, codeFolding, foldGutter, indentUnit } from '@codemirror/language'
import { lintGutter } from '@codemirror/lint'
import { highlightSelectionMatches, search } from '@codemirror/search'
import { Compartment, EditorState, type Extension } from '@codemirror/state'
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
  tooltips,
  type ViewUpdate,
} from '@codemirror/view'
import type { EditEntry } from '../studio/edit_table'
import type { LineContent, ResultCounts } from '../studio/line_contents'
import { countsOf, type LineResults, NO_RESULTS, onLineResults } from '../studio/line_results'
import type { Problem } from '../studio/problems'
import type { StudioStore, Wrap } from '../studio/state'
import type { WayBack } from '../studio/text_desk'
import { resultWords } from '../text/line_results'
import { commandOf } from './edit_actions'
import { editorKeys } from './editor_keymap'
import { External, takenOver } from './external'
import { showFound } from './found_marks'
import { LanguageClient } from './language_client'
import { closesLateWords } from './late_words'
import { LineEnds } from './line_ends'
import type { LineInSight } from './line_in_sight'
import { lineMarks, type MarkedLines, showMarks } from './marks'
import { panelRoom } from './panel_room'
import { pasted } from './pasted'
import { prolog } from './prolog_language'
import { refusalsOfThisText } from './refusals'
import { resultMarks, showResults } from './result_marks'
import { staysOpen } from './shown_marks'
import { task } from './task_language'
import { asTaught, lastTaught, standingTaught, stands, taughtMove } from './taught_move'
import { theme } from './theme'
import { toml } from './toml_language'
import { trueCursor } from './true_cursor'
import { inPlace, lineInSight } from './view_sight'
import { words } from './words'
import type { OpenedDocument } from './workspace'

export interface EditorDocument extends OpenedDocument {
  /** Grows when the text was replaced from outside; the editor then takes it over and keeps its history. */
  readonly revision: number
}

export interface ProgramEditorOptions {
  /** Address of the language server's socket. */
  readonly server: string
  /** Keys of commands that act while text is typed, as `Ctrl+Enter`: the editor leaves them alone. */
  readonly taken: () => ReadonlySet<string>
  readonly onChange: (document: string, text: string) => void
  /** The user has put the cursor on another line (from 1). */
  readonly onLine: (document: string, line: number) => void
  readonly onProblems: (problems: readonly Problem[], documents: ReadonlySet<string>) => void
  /** What the results of the lines of a document hang on has been told anew. */
  readonly onLines: (document: string, lines: readonly LineContent[]) => void
  /** A definition stands in another document: show that. */
  readonly onShow: (document: string) => void
  /** A new name changes a document that is not shown. */
  readonly onWrite: (document: string, change: (text: string) => string) => void
}

interface Kept {
  readonly state: EditorState
  readonly revision: number
  readonly ends: LineEnds
  readonly scroll: { readonly top: number; readonly left: number }
}

/** Colours and folding by the language of a document; code of ICR has none. */
const LANGUAGES: Readonly<Record<string, () => Extension>> = { task, toml, prolog }

function countsIn(results: LineResults): ResultCounts | null {
  if (results.size === 0) return null
  const { valid, pending, stale } = countsOf(results)
  return { children: resultWords.summary(valid, pending, stale), title: resultWords.title }
}

export class ProgramEditor {
  readonly #options: ProgramEditorOptions
  readonly #view: EditorView
  readonly #language: LanguageClient
  readonly #kept = new Map<string, Kept>()
  readonly #access = new Compartment()
  #name = ''
  /** Number of the newest change that taught something. */
  #taught = 0
  #revision = 0
  #ends = new LineEnds('')
  #line = 0
  #isReadOnly = false
  readonly #wrapping = new Compartment()
  #wrap: Wrap = 'off'
  #marks: MarkedLines = { running: null, ghost: null }
  #results: LineResults = NO_RESULTS
  readonly #sight: LineInSight

  constructor(host: HTMLElement, options: ProgramEditorOptions) {
    this.#options = options
    this.#view = new EditorView({ parent: host, state: EditorState.create({ extensions: [nonce(), theme] }) })
    const { server, onProblems, onLines, onWrite } = options
    this.#language = new LanguageClient(server, {
      onProblems,
      onLines,
      onWrite,
      onShow: async name => {
        if (name) options.onShow(name)
        return name === this.#name ? this.#view : null
      },
    })
    this.#sight = lineInSight(this.#view)
  }

  /** Name of the document in the view, empty before the first. */
  get document(): string {
    return this.#name
  }

  /** The text in the view, with the line ends of its file. */
  text(): string {
    return this.#ends.text(this.#view.state.doc)
  }

  /** Tell the language server about all documents of the project. */
  keep(documents: readonly OpenedDocument[]): void {
    this.#language.keep(documents.map(one => (one.name === this.#name ? { ...one, text: this.text() } : one)))
    const names = new Set(documents.map(one => one.name))
    for (const name of this.#kept.keys()) {
      if (!names.has(name)) this.#kept.delete(name)
    }
  }

  /** Show a document; one that was shown before comes back with its history, cursor and folds. */
  open(document: EditorDocument): void {
    if (document.name !== this.#name) this.#switchTo(document)
    if (document.revision !== this.#revision) this.#takeOver(document)
  }

  /** Mark the line that runs (from 1), null for none. Cheap where nothing changes. */
  markRunning(line: number | null): void {
    this.#mark({ ...this.#marks, running: line })
  }

  /** Scroll to the running line where it is out of sight and the user leaves the text alone. */
  followRunning(): void {
    const { running } = this.#marks
    if (running !== null && running <= this.#view.state.doc.lines) this.#sight.show(running)
  }

  /** Mark the line whose pose is shown as a ghost. */
  markGhost(line: number | null): void {
    this.#mark({ ...this.#marks, ghost: line })
  }

  /** Mark what runs have found in the document that is shown. */
  markFound(problems: readonly Problem[]): void {
    this.#language.setFound(problems)
    if (this.#name) showFound(this.#view, problems)
  }

  /** Mark beside the lines of a document which results are those of the text, from now on; return how to end that. */
  followResults(store: StudioStore, document: string): () => void {
    return onLineResults(store, document, results => {
      this.#results = results
      if (this.#name) showResults(this.#view, results)
      store.setState({ counts: countsIn(results) })
    })
  }

  /** Show the running line in grey while the run belongs to an older text. */
  markStale(state: 'stale' | 'current'): void {
    this.#view.dom.classList.toggle('ropsim-stale', state === 'stale')
  }

  setReadOnly(access: 'read' | 'write'): void {
    this.#isReadOnly = access === 'read'
    this.#view.dispatch({ effects: this.#access.reconfigure(EditorState.readOnly.of(this.#isReadOnly)) })
  }

  /** Put the cursor on a place, both counted from 1, and show it in the middle. */
  goTo(line: number, column: number): void {
    const { doc } = this.#view.state
    const at = doc.line(Math.min(Math.max(line, 1), doc.lines))
    const anchor = Math.min(at.from + Math.max(column - 1, 0), at.to)
    this.#view.dispatch({
      selection: { anchor },
      effects: EditorView.scrollIntoView(anchor, { y: 'center' }),
      userEvent: 'select.goto',
    })
    this.#view.focus()
  }

  /** Declare a location under a new name, and write a move to it at the cursor, or its name in a line. */
  teach(location: string, taken: ReadonlySet<string>): WayBack | null {
    if (this.#isReadOnly || !this.#name) return null
    const [name, number] = [this.#name, ++this.#taught]
    const taught = this.#view.state.update(taughtMove(this.#view.state, location, taken), {
      userEvent: 'input.paste',
      effects: asTaught(number),
    })
    const line = this.#view.state.doc.lineAt(this.#view.state.selection.main.head).from
    inPlace(this.#view, line, taught)
    this.#view.dispatch({ effects: EditorView.scrollIntoView(this.#view.state.selection.main.head) })
    this.#view.focus()
    const [before, after] = [taught.startState.doc, this.#view.state.doc]
    return {
      stands: () => this.#name !== name || stands(this.#view.state, number),
      undo: () => this.#view.state.doc.eq(after) && undo(this.#view),
      redo: () => this.#view.state.doc.eq(before) && redo(this.#view),
    }
  }

  /** Do what a command of the Edit menu says, as its key does. */
  act(entry: EditEntry): void {
    if (!this.#name) return
    this.#view.focus()
    commandOf(entry)(this.#view)
  }

  /** Break lines that are longer than the panel is wide, or let them run out of sight. */
  setWrap(wrap: Wrap): void {
    this.#wrap = wrap
    this.#view.dispatch({ effects: this.#wrapping.reconfigure(wrapping(wrap)) })
  }

  focus(): void {
    this.#view.focus()
  }

  destroy(): void {
    this.#language.destroy()
    this.#view.destroy()
  }

  #switchTo(document: EditorDocument): void {
    this.#language.sync()
    if (this.#name) {
      this.#kept.set(this.#name, {
        state: this.#view.state,
        revision: this.#revision,
        ends: this.#ends,
        scroll: { top: this.#view.scrollDOM.scrollTop, left: this.#view.scrollDOM.scrollLeft },
      })
    }
    const kept = this.#kept.get(document.name)
    this.#name = document.name
    this.#revision = kept?.revision ?? document.revision
    this.#ends = kept?.ends ?? new LineEnds(document.text)
    this.#line = 0
    this.#marks = { running: null, ghost: null } // marks belong to the text they were given for
    this.#results = NO_RESULTS
    const state =
      kept?.state ?? EditorState.create({ doc: document.text, extensions: this.#extensions(document) })
    this.#view.setState(state)
    this.setReadOnly(this.#isReadOnly ? 'read' : 'write')
    this.setWrap(this.#wrap)
    // To whole places, at once: the text before may have been scrolled in either direction.
    this.#view.scrollDOM.scrollTo({ top: 0, left: 0, ...kept?.scroll, behavior: 'instant' })
    showMarks(this.#view, this.#marks)
    showResults(this.#view, this.#results)
    this.#language.showKnown(this.#view)
  }

  #takeOver(document: EditorDocument): void {
    this.#revision = document.revision
    const change = takenOver(this.#view.state.doc, document.text)
    if (change) this.#view.dispatch(change)
    this.#ends = new LineEnds(document.text)
  }

  #mark(marks: MarkedLines): void {
    this.#marks = marks
    if (this.#name) showMarks(this.#view, marks)
  }

  #updated(update: ViewUpdate): void {
    if (update.docChanged) {
      this.#ends.change(update.startState.doc, update.state.doc, update.changes)
      const isOwn = update.transactions.some(one => one.docChanged && !one.annotation(External))
      if (isOwn) this.#options.onChange(this.#name, this.text())
    }
    if (!update.selectionSet || !update.transactions.some(one => one.isUserEvent('select'))) return
    const line = update.state.doc.lineAt(update.state.selection.main.head).number
    if (line === this.#line) return
    this.#line = line
    this.#options.onLine(this.#name, line)
  }

  #extensions(document: EditorDocument): Extension {
    return [
      nonce(),
      this.#access.of(EditorState.readOnly.of(this.#isReadOnly)),
      this.#wrapping.of(wrapping(this.#wrap)),
      EditorState.phrases.of(words.phrases),
      lineMarks(),
      lineNumbers(),
      resultMarks(),
      foldGutter(),
      codeFolding(),
      lintGutter(),
      staysOpen(),
      closesLateWords(),
      panelRoom(),
      trueCursor(),
      pasted,
      lastTaught,
      standingTaught,
      history(),
      drawSelection(),
      highlightActiveLine(),
      highlightActiveLineGutter(),
      highlightSelectionMatches(),
      bracketMatching(),
      indentUnit.of('  '),
      search({ top: true }),
      // Lists and hints may be larger than the panel; they stay inside the page's landmark.
      tooltips({ parent: this.#view.dom.closest('main') ?? window.document.body }),
      LANGUAGES[document.language]?.() ?? [],
      this.#language.extension(document),
      keymap.of(editorKeys(this.#options.taken())),
      theme,
      refusalsOfThisText,
      // What scrolls must take the keyboard, also by the letter of the rule.
      EditorView.contentAttributes.of({ 'aria-label': words.label(document.name), tabindex: '0' }),
      EditorView.updateListener.of(update => this.#updated(update)),
    ]
  }
}

function wrapping(wrap: Wrap): Extension {
  return wrap === 'on' ? EditorView.lineWrapping : []
}

/** The page's content policy allows styles with its nonce only. */
function nonce(): Extension {
  const tag = document.querySelector<HTMLElement>('meta[property=csp-nonce]')
  return EditorView.cspNonce.of(tag?.nonce ?? '')
}
