/** What stands in the cell: show or hide it, make it transparent, select it. */
import { prefixOf } from '../run/station'
import type { Body, SceneDescription } from '../scene/description'
import { useStudio, useStudioState } from '../studio/context'
import { words } from '../text/messages'
import { formatQuantity } from '../units/quantity'
import { Scroll } from './Scroll'

interface Branch {
  readonly name: string
  readonly has: (body: Body) => boolean
}

/** Robots one by one, then what is of a kind. */
function branchesOf({ stations }: SceneDescription): readonly Branch[] {
  const isArm = ({ kind }: Body) => kind === 'base' || kind === 'link' || kind === 'cylinder'
  return [
    ...stations.map(({ name }) => ({
      name: stations.length > 1 ? words.cell.robotOf(name) : words.cell.robot,
      has: (body: Body) => isArm(body) && body.name.startsWith(prefixOf(name)),
    })),
    { name: words.cell.tools, has: ({ kind }) => kind === 'tool' },
    { name: words.cell.devices, has: ({ kind }) => kind === 'device' },
    { name: words.cell.objects, has: ({ kind }) => kind === 'object' },
    { name: words.cell.parts, has: ({ kind }) => kind === 'part' },
  ]
}

export function CellPanel() {
  const scene = useStudioState(state => state.scene)
  if (!scene) return <p className="empty">{words.cell.none}</p>
  return (
    <Scroll label={words.cell.tree} className="cell-tree">
      <p>
        <strong>{scene.project}</strong> <span className="quiet">{titlesOf(scene)}</span>
      </p>
      {branchesOf(scene).map(branch => {
        const members = scene.bodies
          .map((body, index) => ({ body, index }))
          .filter(({ body }) => branch.has(body))
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

/** Makers and models of the robots, each once. */
function titlesOf({ stations }: SceneDescription): string {
  return [...new Set(stations.map(one => one.title))].join(', ')
}

function BodyRow({ body, index }: { body: Body; index: number }) {
  const studio = useStudio()
  const selected = useStudioState(state => state.selected === index)
  const hidden = useStudioState(state => state.look.hidden.includes(body.name))
  const opacity = useStudioState(state => state.look.opacity[body.name] ?? 1)
  const look = () => studio.store.getState().look
  const name = body.name.replace(/(^|\/)tool:/, '$1')
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
