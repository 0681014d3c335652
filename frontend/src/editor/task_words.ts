/** Tells the words of the task language apart; words may be written in any case. */
import { ExternalTokenizer, type InputStream } from '@lezer/lr'
import {
  CallWord,
  End,
  Function as FunctionWord,
  Number as NumberWord,
  StatementWord,
  Task,
  Word,
} from './generated/task-parser.terms.js'

const STATEMENTS =
  'program units classic strict frame loc tool signal const var pattern needs assumes endp endtask mov movj lin movl ' +
  'open close load set wait if else elseif endif repeat endr until while endw for endf with endwith break continue ' +
  'return stop print use import robot circ movc spline pulse parallel sync on resume restart skip try catch raise ' +
  'abort endon endtry endpar'
const WORDS =
  'and or not mod in above offset rel is to then do true false here home each step from order grid off speed acc ' +
  'blend fine timeout angle via at after before store external free joints down rx ry rz rpy euler quat rotvec like pitch roll ' +
  'track along gain yaw config turns analog input output'
const FUNCTIONS = 'dist sqrt sin cos tan asin acos atan2 abs min max round trunc'

const TERMS = new Map<string, number>([
  ...STATEMENTS.split(' ').map((word): [string, number] => [word, StatementWord]),
  ...WORDS.split(' ').map((word): [string, number] => [word, Word]),
  ...FUNCTIONS.split(' ').map((word): [string, number] => [word, FunctionWord]),
  ['task', Task],
  ['call', CallWord],
])

/** The parser's term for a word, -1 for a name. */
export function specializeWord(word: string): number {
  return TERMS.get(word.toLowerCase()) ?? -1
}

const LINE_FEED = 10
const LONGEST_COMMENT = 2000

/** Takes `end` where nothing but a full stop or a comment follows it on its line. */
export const endToken = new ExternalTokenizer((input: InputStream) => {
  let line = ''
  for (let at = 0; at < LONGEST_COMMENT; at += 1) {
    const code = input.peek(at)
    if (code < 0 || code === LINE_FEED) break
    line += String.fromCharCode(code)
    if (at === 2 && line.toLowerCase() !== 'end') return
  }
  if (/^end[ \t\r]*\.?[ \t\r]*(?:$|#|\/\/)/i.test(line)) input.acceptToken(End, 3)
})

const NUMBER =
  /^\d+(?:\.\d+)?(?:[eE][+-]?\d+)?(?:[ \t]*(?:(?:(?:mm|cm|m|deg|rad)(?:\/s2?)?|inch|ms|min|s|kg|g|Nm|N|V|mA)(?![A-Za-z0-9_])|%))?/
const LONGEST_NUMBER = 80

function isDigit(code: number): boolean {
  return code >= 48 && code <= 57
}

/** Takes a number with its unit, if one follows. */
export const numberToken = new ExternalTokenizer((input: InputStream) => {
  if (!isDigit(input.next)) return
  let text = ''
  for (let at = 0; at < LONGEST_NUMBER; at += 1) {
    const code = input.peek(at)
    if (code < 0 || code === LINE_FEED) break
    text += String.fromCharCode(code)
  }
  const found = NUMBER.exec(text)
  if (found) input.acceptToken(NumberWord, found[0].length)
})
