/** How the cell is looked at: layout, shading, frames, lights, what is hidden. Kept with the project. */

import type { SceneDescription } from '../scene/description'
import {
  type FrameKind,
  LAYOUTS,
  type Layout,
  type Lights,
  PATHS,
  type PathShown,
  SHADINGS,
  type Shading,
} from '../scene/settings'
import type { Stage } from '../scene/stage'

export interface Look {
  readonly layout: Layout
  readonly shading: Shading
  readonly frames: readonly FrameKind[]
  readonly names: boolean
  /** How much of the tool's path is drawn. */
  readonly path: PathShown
  /** Opacity of base, links and tools, 0.1 … 1. */
  readonly arm: number
  /** Null: as designed. */
  readonly lights: Lights | null
  /** Whether bodies throw shadows. */
  readonly shadows: boolean
  /** Names of bodies. */
  readonly hidden: readonly string[]
  readonly opacity: Readonly<Record<string, number>>
}

export const DEFAULT_LOOK: Look = {
  layout: '4',
  shading: 'standard',
  frames: ['world', 'tcp'],
  names: false,
  path: 'recent',
  arm: 1,
  lights: null,
  shadows: true,
  hidden: [],
  opacity: {},
}

/** The kept look, or the default where it cannot be read; `layout` where none is kept. */
export function lookFrom(kept: unknown, layout: Layout = DEFAULT_LOOK.layout): Look {
  const look = { ...DEFAULT_LOOK, layout, ...(kept as Partial<Look> | null) }
  const sound =
    LAYOUTS.includes(look.layout) &&
    SHADINGS.includes(look.shading) &&
    PATHS.includes(look.path) &&
    Array.isArray(look.frames) &&
    Array.isArray(look.hidden) &&
    typeof look.arm === 'number' &&
    typeof look.opacity === 'object' &&
    look.opacity !== null
  return sound ? look : DEFAULT_LOOK
}

const ARM = new Set(['base', 'link', 'cylinder', 'tool'])

/** Tell the stage. Bodies are found by name, so that the look outlives a change of the cell. */
export function applyLook(stage: Stage, look: Look, scene: SceneDescription | null): void {
  stage.layout(look.layout)
  stage.setShading(look.shading)
  stage.frames(new Set(look.frames))
  stage.labels(look.names)
  if (look.lights) stage.setLights(look.lights)
  stage.shadows(look.shadows)
  scene?.bodies.forEach((body, at) => {
    stage.setHidden(at, look.hidden.includes(body.name))
    stage.setOpacity(at, look.opacity[body.name] ?? (ARM.has(body.kind) ? look.arm : 1))
  })
}
