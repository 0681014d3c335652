/** Numbers of a point as they are copied from a program, a table or a sheet. */

const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i
const DECIMAL_COMMA = /^[+-]?\d+,\d+$/
/** How many numbers a point has. */
const COUNTS: readonly number[] = [3, 5, 6]

/**
 * The numbers of one line: X Y Z, with Pitch Roll or Pitch Roll Yaw; none where it is no point. They stand between
 * commas, blanks, tabs or semicolons, in parentheses or not, with mm and deg or not, behind a name or not. A comma is a
 * decimal point where something else separates the numbers.
 */
export function pastedNumbers(text: string): readonly string[] {
  const line = text
    .trim()
    .replaceAll('−', '-')
    .replace(/^[([{]|[)\]}]$/g, '')
  if (line === '' || /[\r\n]/.test(line)) return []
  for (const cells of divided(line)) {
    const plain = cells.map(one => one.replace(/\s*(?:mm|deg|°)$/i, '').trim())
    const named = plain.length > 3 && !isNumber(plain[0] ?? '') ? plain.slice(1) : plain
    while (named.at(-1) === '') named.pop()
    if (COUNTS.includes(named.length) && named.every(isNumber)) return named.map(one => one.replace(',', '.'))
  }
  return []
}

/** The cells of a line by what may separate them, the surest first. */
function divided(line: string): readonly (readonly string[])[] {
  if (/[\t;]/.test(line)) return [line.split(/[\t;]/)]
  return [line.split(/,\s+/), line.split(/\s+/), line.split(/\s*,\s*/), line.split(/[,\s]+/)]
}

function isNumber(cell: string): boolean {
  return NUMBER.test(cell) || DECIMAL_COMMA.test(cell)
}
