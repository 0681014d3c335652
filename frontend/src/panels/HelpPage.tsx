/** A page of the documentation as elements; its text stays text, its links lead inside of the help. */
import { Fragment } from 'react'
import type { Block, Inline } from '../help/markdown'

interface HelpPageProps {
  readonly blocks: readonly Block[]
  /** Follow a link; false where it leads out of the help. */
  readonly leads: (target: string) => boolean
  readonly follow: (target: string) => void
}

export function HelpPage({ blocks, ...links }: HelpPageProps) {
  // Blocks of a page never change places.
  // biome-ignore lint/suspicious/noArrayIndexKey: see above
  return blocks.map((block, at) => <BlockView key={at} block={block} {...links} />)
}

type Links = Omit<HelpPageProps, 'blocks'>

function BlockView({ block, ...links }: { block: Block } & Links) {
  switch (block.kind) {
    case 'heading': {
      const Heading = block.level < 3 ? 'h2' : 'h3'
      return (
        <Heading id={`help-${block.id}`} tabIndex={-1}>
          <Text text={block.text} {...links} />
        </Heading>
      )
    }
    case 'paragraph':
      return (
        <p>
          <Text text={block.text} {...links} />
        </p>
      )
    case 'code':
      return (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must take the keyboard
        <pre data-language={block.language} tabIndex={0}>
          <code>{block.text}</code>
        </pre>
      )
    case 'list': {
      const List = block.ordered ? 'ol' : 'ul'
      return (
        <List>
          {block.items.map((item, at) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: items never change places
            <li key={at}>
              <Text text={item} {...links} />
            </li>
          ))}
        </List>
      )
    }
    case 'table':
      return <TableView block={block} {...links} />
  }
}

function TableView({ block, ...links }: { block: Extract<Block, { kind: 'table' }> } & Links) {
  return (
    <table>
      <thead>
        <tr>
          {block.head.map((cell, at) => {
            // An empty cell heads nothing.
            const Head = cell.length > 0 ? 'th' : 'td'
            return (
              // biome-ignore lint/suspicious/noArrayIndexKey: cells never change places
              <Head key={at}>
                <Text text={cell} {...links} />
              </Head>
            )
          })}
        </tr>
      </thead>
      <tbody>
        {block.rows.map((row, line) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: rows never change places
          <tr key={line}>
            {row.map((cell, at) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: cells never change places
              <td key={at}>
                <Text text={cell} {...links} />
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  )
}

function Text({ text, leads, follow }: { text: readonly Inline[] } & Links) {
  return text.map((one, at) => {
    const key = `${at}${one.text}`
    if (one.kind === 'code') return <code key={key}>{one.text}</code>
    if (one.kind === 'strong') return <strong key={key}>{one.text}</strong>
    if (one.kind === 'emphasis') return <em key={key}>{one.text}</em>
    if (one.kind === 'link' && leads(one.target))
      return (
        <button key={key} type="button" className="help-link" onClick={() => follow(one.target)}>
          {one.text}
        </button>
      )
    return <Fragment key={key}>{one.text}</Fragment>
  })
}
