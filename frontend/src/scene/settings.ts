/** What can be set and asked of the 3-D stage: plain values, free of three.js. */
import type { FrameMark, Vector3 } from './description'
import type { Words } from './words'

/** One view, two side by side, two by two, or one large with three beside it. */
export const LAYOUTS = ['1', '2', '4', '3+1'] as const
export type Layout = (typeof LAYOUTS)[number]

export const PRESETS = ['perspective', 'top', 'front', 'right', 'isometric'] as const
/** A named direction of view; `custom` after the user has turned a preset away. */
export type Preset = (typeof PRESETS)[number] | 'custom'

export type Projection = 'perspective' | 'parallel'

export const SHADINGS = ['wireframe', 'hidden', 'flat', 'gouraud', 'standard'] as const
/** How surfaces are drawn; `hidden` is a line drawing with hidden lines removed. */
export type Shading = (typeof SHADINGS)[number]

/** `print`: on white paper. */
export type Theme = 'light' | 'dark' | 'print'
export type FrameKind = FrameMark['kind']

/** Ambient and key light 0 … 2 (1 as designed); the key light's direction in W [rad]. */
export interface Lights {
  readonly ambient: number
  readonly key: number
  readonly azimuth: number
  readonly elevation: number
}

/** Lights as designed: the key light comes over the left shoulder of the first view. */
export const DAYLIGHT: Lights = { ambient: 1, key: 1, azimuth: -1.75, elevation: 0.9 }

/** TCP positions in W, three numbers per sample [m], and the times of the samples [s]. */
export interface Trail {
  readonly times: Float64Array
  readonly points: Float32Array
}

export const PATHS = ['recent', 'all', 'none'] as const
/** How much of the tool's path is drawn: the last seconds and what comes next, all, or nothing. */
export type PathShown = (typeof PATHS)[number]

/** The path is drawn from a time to a time, bright up to `until` [s]. */
export interface PathWindow {
  readonly from: number
  readonly until: number
  readonly to: number
}

/** Where a camera stands: it looks at `target` [m, W] from `azimuth` and `elevation` [rad], `distance` [m] away. */
export interface CameraPose {
  readonly target: Vector3
  readonly azimuth: number
  readonly elevation: number
  readonly distance: number
}

/** One viewport as it can be kept and brought back. */
export interface ViewState extends CameraPose {
  readonly preset: Preset
  readonly projection: Projection
}

/** Layout and cameras; plain values, fit for JSON. */
export interface StageState {
  readonly layout: Layout
  readonly views: readonly ViewState[]
}

export interface Point {
  readonly x: number
  readonly y: number
}

export interface StageStats {
  /** Frames drawn since the stage was made. */
  readonly frames: number
  /** Time of the main thread for one frame [ms]: median and 95 % of the last 300. */
  readonly p50: number
  readonly p95: number
  /** Triangles and draw calls of the last frame, all its views together. */
  readonly triangles: number
  readonly calls: number
  readonly software: boolean
  readonly views: number
  /** Views that still wait to be drawn; 0 when the picture is up to date. */
  readonly pending: number
}

/** Something that could not be drawn as asked. */
export interface StageProblem {
  readonly body: string
  readonly file: string
  readonly reason: string
}

/** Body hit (-1: none), the point in W (null: nothing hit) and the index of the viewport. */
export type PickListener = (body: number, point: Vector3 | null, view: number) => void

export interface StageOptions {
  /** True: cameras jump instead of gliding. */
  readonly reducedMotion?: boolean
  readonly theme?: Theme
  /** Texts in another language. */
  readonly messages?: Partial<Words>
}
