/** Colours of the editor, all from the variables of the page's theme. */
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language'
import type { Extension } from '@codemirror/state'
import { EditorView } from '@codemirror/view'
import { tags } from '@lezer/highlight'

const mix = (color: string, share: number) => `color-mix(in srgb, var(${color}) ${share}%, transparent)`

const view = EditorView.theme({
  // The place of the tooltips has the class of the theme, too: a size is for the editor alone.
  '&': { fontSize: '13px', color: 'var(--text)' },
  '&.cm-editor': { height: '100%', backgroundColor: 'var(--panel)' },
  '&.cm-focused': { outline: '2px solid var(--accent)', outlineOffset: '-2px' },
  '.cm-scroller': { fontFamily: 'ui-monospace, "DejaVu Sans Mono", Consolas, monospace', lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-cursor, .cm-dropCursor': { borderLeftColor: 'var(--text)', borderLeftWidth: '2px' },
  '@media (prefers-reduced-motion: reduce)': {
    '.cm-cursorLayer': { animation: 'none !important' },
  },
  '.cm-gutters': {
    backgroundColor: 'var(--panel)',
    color: 'var(--quiet)',
    borderRight: '1px solid var(--line)',
  },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: mix('--accent', 8) },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: mix('--accent', 30),
  },
  '.cm-selectionMatch': { backgroundColor: mix('--accent', 18) },
  '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': {
    backgroundColor: mix('--good', 25),
    outline: '1px solid var(--good)',
  },
  '.cm-nonmatchingBracket, &.cm-focused .cm-nonmatchingBracket': { outline: '1px solid var(--error)' },
  '.cm-name': { backgroundColor: mix('--accent', 14), borderRadius: '2px' },
  '.cm-name-written': { outline: `1px solid ${mix('--accent', 45)}` },
  '.cm-actions': { display: 'flex', flexWrap: 'wrap', alignItems: 'center', gap: '6px', padding: '6px 8px' },
  '.cm-actions [name=close]': { marginLeft: 'auto' },
  '.cm-actions-refused': { color: 'var(--quiet)', flexBasis: '100%' },
  '.cm-lsp-signature-tooltip': { padding: '4px 8px' },
  '.cm-running': { backgroundColor: 'var(--running)' },
  '.cm-ghost': { backgroundColor: mix('--ghost', 14) },
  '.cm-arrows': { width: '1.1em', textAlign: 'center' },
  '.cm-arrow-running': { color: 'var(--accent)' },
  '.cm-arrow-ghost': { color: 'var(--ghost)' },
  '.cm-results': { width: '6px' },
  '.cm-results span': { display: 'block', height: '100%', width: '0', marginLeft: '1px' },
  '.cm-result-valid': { borderLeft: '3px solid var(--good)' },
  '.cm-result-pending': { borderLeft: '3px dotted var(--accent)' },
  '.cm-results .cm-result-stale': { width: '3px', border: '1px solid var(--warning)' },
  '&.ropsim-stale .cm-running': { backgroundColor: mix('--quiet', 15) },
  '&.ropsim-stale .cm-found': { opacity: '0.5' },
  '&.ropsim-stale .cm-arrow-running': { color: 'var(--quiet)' },
  '.cm-tooltip': {
    backgroundColor: 'var(--panel)',
    color: 'var(--text)',
    border: '1px solid var(--line)',
    maxWidth: 'min(46em, 90vw)',
  },
  '&.cm-editor .cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--text)' },
  '&.cm-editor .cm-panels-top': { borderBottom: '1px solid var(--edge)' },
  '&.cm-editor .cm-panels-bottom': { borderTop: '1px solid var(--edge)' },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    backgroundColor: mix('--accent', 25),
    color: 'var(--text)',
  },
  '.cm-completionDetail': { color: 'var(--quiet)', fontStyle: 'normal', marginLeft: '1em' },
  '.cm-completionIcon': { display: 'none' },
  '.cm-completionInfo, .cm-lsp-hover-tooltip': { padding: '4px 8px' },
  '.cm-lsp-hover-tooltip pre': { margin: '0 0 4px', fontFamily: 'inherit', fontWeight: '600' },
  '.cm-diagnostic': { whiteSpace: 'pre-wrap', padding: '4px 8px' },
  '.cm-diagnosticSource': { color: 'var(--quiet)', opacity: '1', fontSize: '90%' },
  '.cm-diagnosticAction': {
    backgroundColor: 'var(--accent)',
    color: 'var(--on-accent)',
    font: 'inherit',
    minHeight: '24px',
    padding: '2px 8px',
    margin: '4px 4px 0 0',
    display: 'block',
  },
  '&.cm-editor .cm-button, &.cm-editor .cm-textfield': {
    backgroundImage: 'none',
    backgroundColor: 'var(--panel)',
    color: 'var(--text)',
    border: '1px solid var(--edge)',
    borderRadius: '5px',
    font: 'inherit',
    minHeight: '26px',
    padding: '2px 8px',
    margin: '0',
    verticalAlign: 'middle',
  },
  '&.cm-editor .cm-button:hover': { borderColor: 'var(--accent)' },
  '&.cm-editor .cm-panel': { font: 'inherit', fontSize: '13px' },
  '&.cm-editor .cm-panel label': { font: 'inherit', whiteSpace: 'nowrap' },
  '&.cm-editor .cm-panel:is(.cm-search, .cm-gotoLine, .cm-lsp-rename-panel)': { padding: '6px 36px 6px 8px' },
  '&.cm-editor .cm-panel.cm-search :is(.cm-button, .cm-textfield)': { margin: '2px 4px 2px 0' },
  '&.cm-editor .cm-panel [name=close], &.cm-editor .cm-dialog-close': {
    color: 'var(--text)',
    minWidth: '26px',
    minHeight: '26px',
  },
  '.cm-searchMatch': { backgroundColor: mix('--warning', 25) },
  '.cm-searchMatch-selected': { backgroundColor: mix('--warning', 50) },
  '.cm-foldPlaceholder': {
    backgroundColor: 'transparent',
    color: 'var(--quiet)',
    border: '1px solid var(--line)',
  },
})

const colours = HighlightStyle.define([
  { tag: tags.keyword, color: 'var(--accent)', fontWeight: '600' },
  { tag: tags.operatorKeyword, color: 'var(--accent)' },
  { tag: tags.definition(tags.function(tags.variableName)), color: 'var(--text)', fontWeight: '700' },
  { tag: tags.function(tags.variableName), color: 'var(--info)' },
  { tag: tags.number, color: 'var(--good)' },
  { tag: tags.string, color: 'var(--warning)' },
  { tag: tags.heading, color: 'var(--accent)', fontWeight: '700' },
  { tag: tags.propertyName, color: 'var(--info)' },
  { tag: tags.bool, color: 'var(--accent)' },
  { tag: tags.invalid, color: 'var(--error)' },
  { tag: tags.comment, color: 'var(--quiet)', fontStyle: 'italic' },
])

export const theme: Extension = [view, syntaxHighlighting(colours)]
