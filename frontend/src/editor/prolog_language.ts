/** Texts of tasks for CodeMirror: colours of Prolog, comments, brackets. */
import { LanguageSupport, StreamLanguage, type StringStream } from '@codemirror/language'
import { brackets } from './brackets'

interface Scanner {
  /** Inside a comment that goes on from the line before. */
  isComment: boolean
}

function comment(stream: StringStream, state: Scanner): string {
  state.isComment = !stream.match(/^.*?\*\//)
  if (state.isComment) stream.skipToEnd()
  return 'comment'
}

function token(stream: StringStream, state: Scanner): string | null {
  if (state.isComment) return comment(stream, state)
  if (stream.eatSpace()) return null
  if (stream.match('/*')) return comment(stream, state)
  if (stream.match(/^%.*/)) return 'comment'
  if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) return 'string'
  if (stream.match(/^'(?:[^'\\]|\\.)*'?/)) return 'propertyName'
  if (stream.match(/^\d+(?:\.\d+)?(?:e[+-]?\d+)?/i)) return 'number'
  if (stream.match(/^[A-Z_]\w*/)) return 'variableName'
  if (stream.match(/^[a-z]\w*(?=\()/)) return 'keyword'
  if (stream.match(/^\w+/)) return null
  if (stream.match(/^[-+*/\\=<>:]+/)) return 'operator'
  stream.next()
  return null
}

const prologLanguage = StreamLanguage.define<Scanner>({
  name: 'prolog',
  startState: () => ({ isComment: false }),
  token,
  languageData: {
    commentTokens: { line: '%', block: { open: '/*', close: '*/' } },
  },
})

export function prolog(): LanguageSupport {
  const signs = { brackets: ['(', '[', '"'], comment: '%', quotes: '"\'' }
  return new LanguageSupport(prologLanguage, brackets(signs))
}
