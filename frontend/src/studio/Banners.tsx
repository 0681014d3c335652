/** What the user must know above all panels: lost connection, second tab, trust. */
import { type ReactNode, useState } from 'react'
import { words } from '../text/messages'
import { useStudio, useStudioState } from './context'
import { UnsentTexts } from './UnsentTexts'

export function Banners() {
  return (
    <div className="banners">
      <ConnectionBanner />
      <ViewerBanner />
      <TrustBanner />
    </div>
  )
}

function Banner({ level, children }: { level: 'error' | 'warning' | 'info'; children: ReactNode }) {
  return (
    <div className={`banner ${level}`} role={level === 'error' ? 'alert' : 'status'}>
      <strong>{words.levels[level]}</strong>
      {children}
    </div>
  )
}

function ConnectionBanner() {
  const connection = useStudioState(state => state.connection)
  if (connection !== 'lost' && connection !== 'expired') return null
  return (
    <Banner level="error">
      <div>
        {connection === 'lost' ? words.connection.lostLong : words.connection.expiredLong}
        <UnsentTexts />
      </div>
    </Banner>
  )
}

function ViewerBanner() {
  const studio = useStudio()
  const viewer = useStudioState(state => state.connection === 'connected' && !state.editing)
  const unsaved = useStudioState(state => state.documents)
  if (!viewer) return null
  return (
    <Banner level="info">
      <span>
        {words.viewer} {unsaved && !studio.desk.delivered ? words.viewerUnsent : ''}
      </span>
      <button type="button" onClick={() => studio.takeOver()}>
        {words.takeOver}
      </button>
    </Banner>
  )
}

function TrustBanner() {
  const studio = useStudio()
  const trust = useStudioState(state => state.trust)
  const [left, setLeft] = useState(false)
  if (trust.trusted || trust.code.length === 0 || left) return null
  return (
    <Banner level="warning">
      <div>
        {words.trust.untrusted(trust.code.length)}
        <details>
          <summary>{words.trust.files}</summary>
          <ul>
            {trust.code.map(file => (
              <li key={file}>
                <code>{file}</code>
              </li>
            ))}
          </ul>
        </details>
      </div>
      <button type="button" onClick={() => studio.send({ type: 'trust', trusted: true })}>
        {words.trust.trust}
      </button>
      <button type="button" onClick={() => setLeft(true)}>
        {words.trust.leave}
      </button>
    </Banner>
  )
}
