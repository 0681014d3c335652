// Makes the editor's parser from its grammar. `node grammar.js`, ahead of everything that imports the parser.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { buildParserFile } from '@lezer/generator'

const grammar = 'src/editor/task.grammar'
const folder = 'src/editor/generated'

const { parser, terms } = buildParserFile(readFileSync(grammar, 'utf8'), { fileName: grammar })
mkdirSync(folder, { recursive: true })
writeFileSync(`${folder}/task-parser.js`, parser)
writeFileSync(`${folder}/task-parser.terms.js`, terms)
