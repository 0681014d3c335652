/** From what a new project is made: an example, or a cell for one of the built-in robots. */
import { useEffect } from 'react'
import { fileWords } from '../text/files'
import type { ExampleState } from '../wire/messages'
import { useStudio, useStudioState } from './context'
import type { ProjectOrigin } from './studio'

const words = fileWords.dialog

/** Names of examples and robots may be the same; of a robot there is something before its name. */
const ROBOT = 'robot '

interface OriginChoiceProps {
  readonly origin: ProjectOrigin
  readonly examples: readonly ExampleState[]
  readonly onOrigin: (origin: ProjectOrigin) => void
}

export function OriginChoice({ origin, examples, onOrigin }: OriginChoiceProps) {
  const studio = useStudio()
  const robots = useStudioState(state => state.robots)
  useEffect(() => studio.listRobots(), [studio])
  const choose = (value: string) =>
    onOrigin(
      value.startsWith(ROBOT)
        ? { ...origin, robot: value.slice(ROBOT.length) }
        : { example: value, robot: '' },
    )
  return (
    <label>
      {words.origin}
      <select
        value={origin.robot ? `${ROBOT}${origin.robot}` : origin.example}
        onChange={event => choose(event.target.value)}
      >
        <optgroup label={words.examples}>
          {examples.map(one => (
            <option key={one.name} value={one.name}>
              {one.name} – {one.summary}
            </option>
          ))}
        </optgroup>
        {robots.length > 0 ? (
          <optgroup label={words.robots}>
            {robots.map(one => (
              <option key={one} value={`${ROBOT}${one}`}>
                {one}
              </option>
            ))}
          </optgroup>
        ) : null}
      </select>
    </label>
  )
}
