/** What a cell looks like, as `ropsim.views.scene` writes it. Metres, radians, world frame W with z up. */

/** Position x, y, z [m] and unit quaternion w, x, y, z. */
export type Pose = readonly [number, number, number, number, number, number, number]

/** What a surface looks as if it were made of. */
export type Material = 'paint' | 'steel' | 'wood' | 'cardboard' | 'rubber' | 'glass'

export type Vector3 = readonly [number, number, number]

interface ShapeBase {
  /** Pose of the shape in the frame of its body. */
  readonly pose: Pose
  /** `#rrggbb` */
  readonly colour: string
  /** 0 invisible … 1 opaque */
  readonly opacity: number
  /** How the colour takes the light; lines and meshes with colours of their own have it, too. */
  readonly material: Material
}

/** Edges along x, y, z; centred at the origin of its pose. */
export interface BoxShape extends ShapeBase {
  readonly kind: 'box'
  readonly size: Vector3
}

/** Round about z, centred; `top` is the radius at +z (equal to `radius` for a cylinder). */
export interface CylinderShape extends ShapeBase {
  readonly kind: 'cylinder'
  readonly radius: number
  readonly top: number
  readonly length: number
}

export interface SphereShape extends ShapeBase {
  readonly kind: 'sphere'
  readonly radius: number
}

/** A profile of (r, z) points turned about z. */
export interface RevolveShape extends ShapeBase {
  readonly kind: 'revolve'
  readonly profile: readonly (readonly [number, number])[]
}

/** A simple polygon in x, y, drawn out along +z from z = 0. */
export interface PrismShape extends ShapeBase {
  readonly kind: 'prism'
  readonly outline: readonly (readonly [number, number])[]
  readonly length: number
}

/** A polyline; circles and arcs come as points. */
export interface LineShape extends ShapeBase {
  readonly kind: 'line'
  readonly points: readonly Vector3[]
}

/** A mesh of a file; `mesh` is its content address, empty where it cannot be had, then `missing` says why. */
export interface MeshShape extends ShapeBase {
  readonly kind: 'mesh'
  readonly mesh: string
  readonly file: string
  readonly missing: string
}

export type Shape = BoxShape | CylinderShape | SphereShape | RevolveShape | PrismShape | LineShape | MeshShape

export type BodyKind = 'base' | 'link' | 'cylinder' | 'tool' | 'device' | 'object' | 'part'

export interface Body {
  readonly name: string
  readonly kind: BodyKind
  /** Index of the body on which it is fixed (a tool on the last link); -1 for the world. */
  readonly parent: number
  /** Pose at the start of a run: in the frame of `parent`, else in the world. */
  readonly pose: Pose
  readonly shapes: readonly Shape[]
  /** False for a part that still waits in its supply. */
  readonly visible: boolean
}

/** A coordinate system that is drawn as an axis cross. */
export interface FrameMark {
  readonly name: string
  readonly kind: 'world' | 'base' | 'frame' | 'location' | 'tcp'
  /** Body that carries it, -1 for the world. */
  readonly parent: number
  readonly pose: Pose
}

export interface JointDescription {
  readonly name: string
  readonly type: 'revolute' | 'prismatic'
  /** [rad | m] */
  readonly lower: number
  readonly upper: number
  readonly maxSpeed: number
}

export interface SignalDescription {
  readonly name: string
  readonly input: boolean
  readonly analog: boolean
  readonly initial: number
}

/** A robot with the program that it runs and the tool that it holds at the start. */
export interface StationDescription {
  readonly name: string
  /** Short name of the robot. */
  readonly robot: string
  readonly title: string
  /** Name of the program that it runs where the user names none. */
  readonly program: string
  /** Empty for none. */
  readonly tool: string
  /** Pose of the robot's base frame B in W. */
  readonly base: Pose
  readonly joints: readonly JointDescription[]
}

export interface SceneDescription {
  readonly version: 2
  readonly project: string
  /** At least one, in the order of the cell. */
  readonly stations: readonly StationDescription[]
  readonly bodies: readonly Body[]
  readonly frames: readonly FrameMark[]
  readonly signals: readonly SignalDescription[]
  /** Box around everything, the reach of the arms included [m]. */
  readonly extent: { readonly min: Vector3; readonly max: Vector3 }
}
