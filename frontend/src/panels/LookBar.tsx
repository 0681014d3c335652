/** The row of settings above the 3-D views. */
import {
  DAYLIGHT,
  type FrameKind,
  LAYOUTS,
  type Layout,
  type Lights,
  PATHS,
  type PathShown,
  SHADINGS,
  type Shading,
} from '../scene/settings'
import { useStudio, useStudioState } from '../studio/context'
import { words } from '../text/messages'
import { Drop } from './Drop'

const FRAMES: readonly FrameKind[] = ['world', 'base', 'frame', 'location', 'tcp']

export function LookBar() {
  const studio = useStudio()
  const look = useStudioState(state => state.look)
  const { views } = words
  const frame = (kind: FrameKind, on: boolean) => {
    const others = look.frames.filter(one => one !== kind)
    studio.setLook({ frames: on ? [...others, kind] : others }, `${views.frames}: ${views.frameNames[kind]}`)
  }
  return (
    <div className="toolbar stage-place-tools" role="toolbar" aria-label={views.tools}>
      <select
        aria-label={views.layout}
        title={views.layout}
        value={look.layout}
        onChange={event => studio.setLook({ layout: event.target.value as Layout }, views.layout)}
      >
        {LAYOUTS.map(one => (
          <option key={one} value={one}>
            {views.layouts[one]}
          </option>
        ))}
      </select>
      <select
        aria-label={views.shading}
        title={views.shading}
        value={look.shading}
        onChange={event => studio.setLook({ shading: event.target.value as Shading }, views.shading)}
      >
        {SHADINGS.map(one => (
          <option key={one} value={one}>
            {views.shadings[one]}
          </option>
        ))}
      </select>
      <button type="button" onClick={() => studio.picture.stage?.fit()}>
        {views.fit}
      </button>
      <Drop title={views.frames}>
        {FRAMES.map(kind => (
          <label key={kind}>
            <input
              type="checkbox"
              checked={look.frames.includes(kind)}
              onChange={event => frame(kind, event.target.checked)}
            />
            {views.frameNames[kind]}
          </label>
        ))}
        <label>
          <input
            type="checkbox"
            checked={look.names}
            onChange={event => studio.setLook({ names: event.target.checked }, views.names)}
          />
          {views.names}
        </label>
      </Drop>
      <LookMenu />
    </div>
  )
}

function LookMenu() {
  const studio = useStudio()
  const lights = useStudioState(state => state.look.lights) ?? DAYLIGHT
  const arm = useStudioState(state => state.look.arm)
  const path = useStudioState(state => state.look.path)
  const shadows = useStudioState(state => state.look.shadows)
  const { views } = words
  const slider = (key: keyof Lights, label: string, min: number, max: number) => (
    <label>
      {label}
      <input
        type="range"
        min={min}
        max={max}
        step={0.05}
        value={lights[key]}
        onChange={event => studio.setLook({ lights: { ...lights, [key]: Number(event.target.value) } })}
      />
    </label>
  )
  return (
    <Drop title={views.lights}>
      <label>
        {views.path}
        <select
          value={path}
          onChange={event => studio.setLook({ path: event.target.value as PathShown }, views.path)}
        >
          {PATHS.map(one => (
            <option key={one} value={one}>
              {views.paths[one]}
            </option>
          ))}
        </select>
      </label>
      <label>
        <input
          type="checkbox"
          checked={shadows}
          onChange={event => studio.setLook({ shadows: event.target.checked }, views.shadows)}
        />
        {views.shadows}
      </label>
      {slider('ambient', views.ambient, 0, 2)}
      {slider('key', views.key, 0, 2)}
      {slider('azimuth', views.azimuth, -Math.PI, Math.PI)}
      {slider('elevation', views.elevation, 0, Math.PI / 2)}
      <label>
        {views.arm}
        <input
          type="range"
          min={0.1}
          max={1}
          step={0.05}
          value={arm}
          onChange={event => studio.setLook({ arm: Number(event.target.value) })}
        />
      </label>
    </Drop>
  )
}
