/** One panel that fails does not take the page with it. */
import { Component, type ReactNode } from 'react'
import { words } from '../text/messages'
import { useStudioState } from './context'

/** What browsers say of a part of the page that could not be loaded; they do not load it twice. */
const NOT_LOADED = /preload|dynamically imported|importing a module/i

interface GuardProps {
  readonly name: string
  readonly children: ReactNode
}

/** Typed text that the server does not have yet is in this page only: it is loaded anew with the server there. */
function Reload() {
  const lost = useStudioState(state => state.connection !== 'connected')
  return (
    <button type="button" disabled={lost} onClick={() => window.location.reload()}>
      {lost ? words.panel.waits : words.panel.reload}
    </button>
  )
}

export class PanelGuard extends Component<GuardProps, { readonly reason: string }> {
  override state = { reason: '' }

  static getDerivedStateFromError(error: unknown): { readonly reason: string } {
    return { reason: error instanceof Error ? error.message : String(error) }
  }

  override render(): ReactNode {
    if (!this.state.reason) return this.props.children
    return (
      <div className="panel-failed" role="alert">
        <p>{words.panel.failed(this.props.name, this.state.reason)}</p>
        {NOT_LOADED.test(this.state.reason) ? (
          <Reload />
        ) : (
          <button type="button" onClick={() => this.setState({ reason: '' })}>
            {words.panel.again}
          </button>
        )}
      </div>
    )
  }
}
