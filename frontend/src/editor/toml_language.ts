/** The cell file for CodeMirror: colours of TOML, comments, brackets. */
import { LanguageSupport, StreamLanguage, type StringStream } from '@codemirror/language'
import { tags } from '@lezer/highlight'
import { brackets } from './brackets'

type Quotes = '"""' | "'''"

interface Scanner {
  /** What closes the string that goes on from the line before. */
  open: Quotes | null
  /** Depth of arrays and inline tables; inside an array a line may begin with a value. */
  depth: number
  /** A `=` has been seen on this line: what follows is a value. */
  isValue: boolean
}

const NUMBER = /^[+-]?(?:0[xob][\da-f_]+|(?:\d[\d_]*)(?:\.[\d_]+)?(?:e[+-]?\d[\d_]*)?|inf\b|nan\b)/i
const TIME =
  /^\d{4}-\d\d-\d\d(?:[ T]\d\d:\d\d(?::\d\d(?:\.\d+)?)?(?:Z|[+-]\d\d:\d\d)?)?|^\d\d:\d\d(?::\d\d(?:\.\d+)?)?/
const KEY = /^[A-Za-z0-9_-]+/

function goOn(stream: StringStream, state: Scanner, quotes: Quotes): string {
  state.open = quotes
  while (!stream.eol()) {
    if (stream.match(quotes)) {
      state.open = null
      break
    }
    if (stream.next() === '\\' && quotes === '"""') stream.next()
  }
  return 'string'
}

function shortString(stream: StringStream, quote: string): string {
  for (let at = stream.next(); at !== undefined && at !== quote; at = stream.next()) {
    if (at === '\\' && quote === '"') stream.next()
  }
  return 'string'
}

function token(stream: StringStream, state: Scanner): string | null {
  if (stream.sol() && state.depth === 0) state.isValue = false
  if (state.open) return goOn(stream, state, state.open)
  if (stream.eatSpace()) return null
  const isHeader = stream.sol() || /^\s*$/.test(stream.string.slice(0, stream.pos))
  if (isHeader && state.depth === 0 && stream.match(/^\[{1,2}[^\]#]*\]{0,2}/)) return 'heading'
  if (stream.match('"""')) return goOn(stream, state, '"""')
  if (stream.match("'''")) return goOn(stream, state, "'''")
  const next = stream.peek() ?? ''
  if (next === '#') {
    stream.skipToEnd()
    return 'comment'
  }
  if (next === '"' || next === "'") {
    stream.next()
    const found = shortString(stream, next)
    return state.isValue ? found : 'propertyName'
  }
  if (state.isValue && (stream.match(TIME) || stream.match(NUMBER))) return 'number'
  if (stream.match(/^(?:true|false)\b/) && state.isValue) return 'bool'
  if (stream.match(KEY)) return state.isValue ? 'invalid' : 'propertyName'
  return sign(stream, state)
}

/** One sign: what opens or closes, and what stands between a key and its value. */
function sign(stream: StringStream, state: Scanner): string | null {
  const found = stream.next()
  if (found === '[' || found === '{') {
    state.depth += 1
    state.isValue = found === '['
  } else if (found === ']' || found === '}') {
    state.depth = Math.max(state.depth - 1, 0)
    state.isValue = true
  } else if (found === '=') {
    state.isValue = true
    return 'operator'
  } else if (found === ',') {
    state.isValue = !isInTable(stream.string.slice(0, stream.pos))
  }
  return null
}

/** Whether the innermost bracket that is open at the end of a piece of line is that of an inline table. */
function isInTable(piece: string): boolean {
  let depth = 0
  for (let at = piece.length - 1; at >= 0; at -= 1) {
    const one = piece[at]
    if (one === ']' || one === '}') depth += 1
    else if ((one === '[' || one === '{') && depth > 0) depth -= 1
    else if (one === '[' || one === '{') return one === '{'
  }
  return false
}

export const tomlLanguage = StreamLanguage.define<Scanner>({
  name: 'toml',
  startState: () => ({ open: null, depth: 0, isValue: false }),
  copyState: state => ({ ...state }),
  token,
  tokenTable: { heading: tags.heading },
  languageData: {
    commentTokens: { line: '#' },
  },
})

export function toml(): LanguageSupport {
  const signs = { brackets: ['(', '[', '{', '"'], comment: '#', quotes: '"\'' }
  return new LanguageSupport(tomlLanguage, brackets(signs))
}
