/** What stands in the cell: show or hide it, make it transparent, select it. */
import type { Body } from '../scene/description'
import { useStudio, useStudioState } from '../studio/context'
import { words } from '../text/messages'
import { formatQuantity } from '../units/quantity'
import { Scroll } from './Scroll'

interface Branch {
  readonly name: string
  readonly kinds: readonly Body['kind'][]
}

const BRANCHES: readonly Branch[] = [
  { name: words.cell.robot, kinds: ['base', 'link'] },
  { name: words.cell.tools, kinds: ['tool'] },
  { name: words.cell.objects, kinds: ['object'] },
  { name: words.cell.parts, kinds: ['part'] },
]

export function CellPanel() {
  const scene = useStudioState(state => state.scene)
  if (!scene) return <p className="empty">{words.cell.none}</p>
  return (
    <Scroll label={words.cell.tree} className="cell-tree">
      <p>
        <strong>{scene.project}</strong> <span className="quiet">{scene.robot.title}</span>
      </p>
      {BRANCHES.map(branch => {
        const members = scene.bodies
          .map((body, index) => ({ body, index }))
          .filter(({ body }) => branch.kinds.includes(body.kind))
        return members.length ? (
          <details key={branch.name} open={members.length <= 12}>
            <summary>
              {branch.name} <span className="quiet">{members.length}</span>
            </summary>
            {members.map(({ body, index }) => (
              <BodyRow key={body.name} body={body} index={index} />
            ))}
          </details>
        ) : null
      })}
      <details>
        <summary>
          {words.cell.frames} <span className="quiet">{scene.frames.length}</span>
        </summary>
        <ul className="frames">
          {scene.frames.map(frame => (
            <li key={`${frame.kind} ${frame.name}`}>
              <span>{frame.name}</span>{' '}
              <span className="quiet">
                {frame.pose
                  .slice(0, 3)
                  .map(one => formatQuantity(one, 'm'))
                  .join(', ')}
              </span>
            </li>
          ))}
        </ul>
      </details>
    </Scroll>
  )
}

function BodyRow({ body, index }: { body: Body; index: number }) {
  const studio = useStudio()
  const selected = useStudioState(state => state.selected === index)
  const hidden = useStudioState(state => state.look.hidden.includes(body.name))
  const opacity = useStudioState(state => state.look.opacity[body.name] ?? 1)
  const look = () => studio.store.getState().look
  const name = body.name.replace(/^tool:/, '')
  return (
    <div className={selected ? 'body-row selected' : 'body-row'}>
      <input
        type="checkbox"
        aria-label={words.cell.show(name)}
        checked={!hidden}
        onChange={event => {
          const others = look().hidden.filter(one => one !== body.name)
          studio.setLook(
            { hidden: event.target.checked ? others : [...others, body.name] },
            words.cell.show(name),
          )
        }}
      />
      <button
        type="button"
        aria-pressed={selected}
        title={words.cell.select(name)}
        onClick={() => studio.select(selected ? null : index)}
      >
        {name}
      </button>
      <input
        type="range"
        aria-label={words.cell.opacity(name)}
        min={0.1}
        max={1}
        step={0.1}
        value={opacity}
        onChange={event =>
          studio.setLook({ opacity: { ...look().opacity, [body.name]: Number(event.target.value) } })
        }
      />
    </div>
  )
}
