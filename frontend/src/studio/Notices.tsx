/** Words of the server and of the page that need no answer. */
import { useEffect } from 'react'
import { Marked } from '../panels/Marked'
import { words } from '../text/messages'
import { useStudio, useStudioState } from './context'
import type { ShownNotice } from './state'

/** Notes and warnings go by themselves after this time [ms]; errors stay. */
const STAY = 20_000

export function Notices() {
  const notices = useStudioState(state => state.notices)
  return (
    <section className="notices" aria-live="polite" aria-label={words.notices}>
      {notices.map(one => (
        <NoticeCard key={one.id} notice={one} />
      ))}
    </section>
  )
}

function NoticeCard({ notice }: { notice: ShownNotice }) {
  const studio = useStudio()
  const { id, level, code, text, hint } = notice
  useEffect(() => {
    if (level === 'error') return
    const timer = setTimeout(() => studio.dismiss(id), STAY)
    return () => clearTimeout(timer)
  }, [studio, id, level])
  return (
    <div className={`notice ${level}`}>
      <div>
        <strong>{words.levels[level]}</strong> {code ? <code>{code}</code> : null} <Marked text={text} />
        {hint ? (
          <p className="quiet">
            <Marked text={hint} />
          </p>
        ) : null}
      </div>
      <button
        type="button"
        aria-label={words.dismiss}
        title={words.dismiss}
        onClick={() => studio.dismiss(id)}
      >
        ×
      </button>
    </div>
  )
}
