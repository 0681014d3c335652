/** One panel that fails does not take the page with it. */
import { Component, type ReactNode } from 'react'
import { words } from '../text/messages'

/** What browsers say of a part of the page that could not be loaded; they do not load it twice. */
const NOT_LOADED = /preload|dynamically imported|importing a module/i

interface GuardProps {
  readonly name: string
  readonly children: ReactNode
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
          <button type="button" onClick={() => window.location.reload()}>
            {words.panel.reload}
          </button>
        ) : (
          <button type="button" onClick={() => this.setState({ reason: '' })}>
            {words.panel.again}
          </button>
        )}
      </div>
    )
  }
}
