/** The task language for CodeMirror: colours, folding, depth of lines, brackets. */
import { foldService, LanguageSupport, LRLanguage } from '@codemirror/language'
import { styleTags, tags } from '@lezer/highlight'
import { foldedBy } from './blocks'
import { brackets } from './brackets'
import { parser } from './generated/task-parser.js'
import { indentation } from './indentation'

export const taskLanguage = LRLanguage.define({
  name: 'task',
  parser: parser.configure({
    props: [
      styleTags({
        'Task StatementWord CallWord End': tags.keyword,
        Word: tags.operatorKeyword,
        Function: tags.standard(tags.function(tags.variableName)),
        'TaskHeader/TaskName': tags.definition(tags.function(tags.variableName)),
        'Call/TaskName': tags.function(tags.variableName),
        'VariableName Name': tags.variableName,
        Member: tags.propertyName,
        Number: tags.number,
        String: tags.string,
        Comment: tags.lineComment,
        'AssignOp Operator': tags.operator,
      }),
    ],
  }),
  languageData: {
    commentTokens: { line: '#' },
  },
})

const SIGNS = {
  brackets: ['(', '[', '"'],
  comment: '#|//',
  quotes: '"',
  prose: /^\s*(?:needs|assumes)\b/i,
} as const

const folding = foldService.of((state, from) => foldedBy(state.doc, state.doc.lineAt(from).number))

export function task(): LanguageSupport {
  return new LanguageSupport(taskLanguage, [folding, indentation(), brackets(SIGNS)])
}
