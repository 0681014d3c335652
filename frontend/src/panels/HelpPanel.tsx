/** Keys, task language, cell file and command line, to read beside the work; nothing comes over a network. */
import { useEffect, useMemo, useRef, useState } from 'react'
import { matchingSections } from '../help/markdown'
import { PAGES, type PageTopic, placeOf } from '../help/pages'
import { TOPICS } from '../help/topics'
import { helpWords as words } from '../help/words'
import { useStudio, useStudioState } from '../studio/context'
import { HelpPage } from './HelpPage'
import { KeySheet } from './KeySheet'
import { Scroll } from './Scroll'
import './help.css'

export function HelpPanel() {
  const { store } = useStudio()
  const topic = useStudioState(state => state.help)
  const [query, setQuery] = useState('')
  return (
    <>
      <div className="toolbar">
        <fieldset className="help-topics" aria-label={words.choose}>
          {TOPICS.map(one => (
            <button
              key={one}
              type="button"
              aria-pressed={one === topic}
              onClick={() => store.setState({ help: one })}
            >
              {words.topics[one]}
            </button>
          ))}
        </fieldset>
        <input
          type="search"
          aria-label={words.search}
          placeholder={words.search}
          value={query}
          onChange={event => setQuery(event.target.value)}
        />
      </div>
      {topic === 'keys' ? (
        <Scroll label={words.topics.keys} className="help">
          <KeySheet query={query} />
        </Scroll>
      ) : (
        <Page topic={topic} query={query} clear={() => setQuery('')} />
      )}
    </>
  )
}

/** One page; a heading that is asked for comes to the top once it is drawn. */
function Page({ topic, query, clear }: { topic: PageTopic; query: string; clear: () => void }) {
  const { store } = useStudio()
  const place = useRef<HTMLDivElement>(null)
  const [wanted, setWanted] = useState('')
  const sections = PAGES[topic]
  const found = useMemo(() => matchingSections(sections, query), [sections, query])
  useEffect(() => {
    if (!wanted || query) return
    const heading = place.current?.querySelector<HTMLElement>(`#help-${CSS.escape(wanted)}`)
    heading?.scrollIntoView({ block: 'start' })
    heading?.focus({ preventScroll: true })
    setWanted('')
  }, [wanted, query])
  const go = (id: string) => {
    clear()
    setWanted(id)
  }
  const follow = (target: string) => {
    const there = placeOf(target, topic)
    if (!there) return
    store.setState({ help: there.topic })
    go(there.id || (PAGES[there.topic][0]?.id ?? ''))
  }
  return (
    <Scroll label={words.topics[topic]} className="help">
      <div ref={place}>
        {query ? null : (
          <nav aria-label={words.contents}>
            {sections
              .filter(one => one.level === 2)
              .map(one => (
                <button key={one.id} type="button" className="help-link" onClick={() => go(one.id)}>
                  {one.title}
                </button>
              ))}
          </nav>
        )}
        {found.length === 0 ? <p className="empty">{words.none}</p> : null}
        {found.map(section => (
          <HelpPage
            key={section.id}
            blocks={section.blocks}
            leads={target => placeOf(target, topic) !== null}
            follow={follow}
          />
        ))}
      </div>
    </Scroll>
  )
}
