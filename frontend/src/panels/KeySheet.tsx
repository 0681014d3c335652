/** All keys on one sheet, taken from the registry of commands: a key that works stands here. */
import { EDITOR_KEYS } from '../help/editor_keys'
import { VIEW_DRAGS, VIEW_KEYS } from '../help/view_keys'
import { helpWords as words } from '../help/words'
import { MENUS } from '../studio/commands'
import { useStudio } from '../studio/context'
import { shownKey } from '../studio/keys'
import { LINE_RESULTS } from '../studio/line_results'
import { resultWords } from '../text/line_results'
import { words as studioWords } from '../text/messages'

type Row = readonly [keys: readonly string[], title: string]

/** The marks beside the lines of a program: their forms differ, too. */
const MARKS = LINE_RESULTS.map((one): Row => [[resultWords.signs[one]], resultWords[one]])

export function KeySheet({ query }: { query: string }) {
  const { commands } = useStudio()
  const wanted = query.toLowerCase().split(/\s+/).filter(Boolean)
  const fits = ([keys, title]: Row) =>
    wanted.every(word => `${keys.join(' ')} ${title}`.toLowerCase().includes(word))
  const menus = MENUS.map(menu => {
    const own = commands.all.filter(one => one.menu === menu && one.keys.length > 0)
    return [studioWords.menus[menu], own.map((one): Row => [one.keys, one.title])] as const
  })
  const drags = VIEW_DRAGS.map(([gesture, title]): Row => [[gesture], title])
  const groups = [
    ...menus,
    [words.editorKeys, EDITOR_KEYS] as const,
    [words.views, VIEW_KEYS] as const,
    [words.mouse, drags] as const,
    [resultWords.legend, MARKS] as const,
  ]
    .map(([name, rows]) => [name, rows.filter(fits)] as const)
    .filter(([, rows]) => rows.length > 0)
  if (groups.length === 0) return <p className="empty">{words.none}</p>
  return (
    <div className="key-sheet">
      {groups.map(([name, rows]) => (
        <div key={name} className="key-group">
          <h2>{name}</h2>
          <dl>
            {rows.map(([keys, title]) => (
              <div key={title}>
                <dt>
                  {keys.map(key => (
                    <kbd key={key}>{shownKey(key)}</kbd>
                  ))}
                </dt>
                <dd>{title}</dd>
              </div>
            ))}
          </dl>
        </div>
      ))}
    </div>
  )
}
