import { LSPClient } from '@codemirror/lsp-client'
import { describe, expect, it } from 'vitest'
import { ProjectWorkspace } from './workspace'

interface Sent {
  readonly id?: number
  readonly method: string
  readonly params: { readonly textDocument?: { readonly uri: string; readonly version?: number } }
}

/** A client whose server answers `initialize` and keeps what it was told. */
async function connected(): Promise<{
  workspace: ProjectWorkspace
  client: LSPClient
  told: Sent[]
  again(): void
}> {
  const client = new LSPClient({ workspace: one => new ProjectWorkspace(one) })
  const told: Sent[] = []
  const again = () => {
    let listen: (message: string) => void = () => {}
    client.connect({
      send: text => {
        const message = JSON.parse(text) as Sent
        told.push(message)
        if (message.method !== 'initialize') return
        const result = { capabilities: { textDocumentSync: 2 } }
        queueMicrotask(() => listen(JSON.stringify({ jsonrpc: '2.0', id: message.id, result })))
      },
      subscribe: listener => {
        listen = listener
      },
      unsubscribe: () => {},
    })
  }
  again()
  await client.initializing
  return { workspace: client.workspace as ProjectWorkspace, client, told, again }
}

const MAIN = { name: 'programs/main.task', uri: 'file:///p/main.task', language: 'task', text: 'mov home' }
const CELL = { name: 'cell.toml', uri: 'file:///p/cell.toml', language: 'toml', text: '[robot]' }

function document(told: readonly Sent[], method: string): (string | undefined)[] {
  return told.filter(one => one.method === `textDocument/${method}`).map(one => one.params.textDocument?.uri)
}

describe('documents at the language server', () => {
  it('are open also where no view shows them', async () => {
    const { workspace, client, told } = await connected()
    workspace.keep([MAIN, CELL])
    await client.initializing
    expect(document(told, 'didOpen')).toEqual([MAIN.uri, CELL.uri])
  })

  it('are told once where their text stays', async () => {
    const { workspace, client, told } = await connected()
    workspace.keep([MAIN])
    workspace.keep([MAIN])
    workspace.keep([{ ...MAIN, text: 'open' }])
    await client.initializing
    expect(document(told, 'didOpen')).toEqual([MAIN.uri])
    expect(document(told, 'didChange')).toEqual([MAIN.uri])
    expect(workspace.getFile(MAIN.uri)?.version).toBe(1)
  })

  it('are closed when the project has lost them', async () => {
    const { workspace, client, told } = await connected()
    workspace.keep([MAIN, CELL])
    workspace.keep([MAIN])
    await client.initializing
    expect(document(told, 'didClose')).toEqual([CELL.uri])
  })

  it('are opened anew after the connection was lost', async () => {
    const { workspace, client, told, again } = await connected()
    workspace.keep([MAIN, CELL])
    await client.initializing
    client.disconnect()
    workspace.keep([{ ...MAIN, text: 'typed meanwhile' }, CELL])
    told.length = 0
    again()
    await client.initializing
    expect(document(told, 'didOpen')).toEqual([MAIN.uri, CELL.uri])
    const opened = told.find(one => one.method === 'textDocument/didOpen')
    expect(JSON.stringify(opened)).toContain('typed meanwhile')
  })
})
