/** The materials of bodies in each way of shading; equal ones are one object. */
import {
  AlwaysStencilFunc,
  DoubleSide,
  FrontSide,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  ReplaceStencilOp,
} from 'three'
import { hatchMaterial } from './hatch'
import type { LightRig } from './light_rig'
import type { Palette } from './palette'
import type { Shading } from './settings'
import { surfaceMaterial } from './surface_material'

/**
 * What a piece of a body is: its surface; the same laid down as depth only, so that a transparent body does not
 * show its own inside; its edges; lines along round faces; drawn lines; the stand-in of a mesh that is missing.
 */
export type Role = 'surface' | 'depth' | 'crease' | 'contour' | 'line' | 'missing'

/** Who wears a material: the robot with its tools, or any other thing. */
export type Wearer = 'arm' | 'thing'

/** What stands in the stencil where the robot is seen. */
export const ARM_MARK = 1

/** What is less opaque throws no shadow. */
const LEAST_OPAQUE = 0.5

export class Materials {
  readonly #made = new Map<string, Material>()
  #shading: Shading = 'standard'

  constructor(
    readonly rig: LightRig,
    private palette: Palette,
  ) {}

  get shading(): Shading {
    return this.#shading
  }

  /** Objects must be dressed anew afterwards. */
  setShading(shading: Shading): void {
    this.#shading = shading
  }

  /** Objects must be dressed anew afterwards. */
  setPalette(palette: Palette): void {
    this.palette = palette
    this.dispose()
  }

  /** The material of a piece; null where this way of shading does not draw it. */
  of(role: Role, opacity: number, open: boolean, wearer: Wearer): Material | null {
    if (!this.#drawn(role, opacity)) return null
    const key = `${role} ${this.#shading} ${opacity} ${open} ${wearer}`
    const known = this.#made.get(key)
    if (known) return known
    const material = this.#make(role, opacity)
    material.side = open ? DoubleSide : FrontSide
    if (wearer === 'arm' && opacity === 1) material.setValues(MARKED)
    this.#made.set(key, material)
    return material
  }

  /** A thing for each material of what stands in a cell. */
  samples(): Object3D[] {
    const surfaces = [false, true].map(open => this.of('surface', 1, open, 'thing'))
    const edge = this.of('crease', 1, false, 'thing')
    return [
      ...surfaces.filter(material => material !== null).map(material => new Mesh(undefined, material)),
      ...(edge ? [new LineSegments(undefined, edge)] : []),
    ]
  }

  /** The robot comes after things that may stand before it: where it is marked, it is seen. */
  order(role: Role, wearer: Wearer): number {
    return role === 'depth' || role === 'surface' ? (wearer === 'arm' ? 0.5 : 0) : 1
  }

  /** Surfaces that light does not pass throw shadows. */
  casts(role: Role, opacity: number): boolean {
    return role === 'surface' && opacity >= LEAST_OPAQUE
  }

  dispose(): void {
    for (const material of this.#made.values()) material.dispose()
    this.#made.clear()
  }

  #drawn(role: Role, opacity: number): boolean {
    const lines = this.#shading === 'wireframe' || this.#shading === 'hidden'
    if (opacity <= 0) return false
    if (role === 'surface') return !lines
    if (role === 'contour') return lines
    if (role === 'depth') return this.#shading === 'hidden' ? opacity === 1 : !lines && opacity < 1
    return true
  }

  #make(role: Role, opacity: number): Material {
    if (role === 'surface') return this.#surface(opacity)
    if (role === 'depth')
      return new MeshBasicMaterial({ colorWrite: false, ...OFFSET, transparent: opacity < 1 })
    if (role === 'missing') return hatchMaterial(this.palette.accent)
    if (role === 'line') {
      return new LineBasicMaterial({ vertexColors: true, transparent: opacity < 1, opacity })
    }
    return this.#edge(role, opacity)
  }

  #edge(role: 'crease' | 'contour', opacity: number): Material {
    if (this.#shading === 'wireframe' || this.#shading === 'hidden') {
      const strength = role === 'crease' ? 0.95 : 0.4
      return new LineBasicMaterial({
        color: this.palette.grid,
        transparent: true,
        opacity: strength * opacity,
        depthWrite: false,
      })
    }
    return new LineBasicMaterial({
      color: this.palette.ink,
      transparent: true,
      opacity: this.palette.inkStrength * opacity,
      depthWrite: false,
    })
  }

  #surface(opacity: number): Material {
    const shades = this.#shading === 'flat' || this.#shading === 'gouraud' ? this.#shading : 'standard'
    const material = surfaceMaterial(this.rig, shades, opacity)
    material.setValues({ ...OFFSET, transparent: opacity < 1 })
    return material
  }
}

const MARKED = {
  stencilWrite: true,
  stencilRef: ARM_MARK,
  stencilFunc: AlwaysStencilFunc,
  stencilZPass: ReplaceStencilOp,
} as const

/** Surfaces step back a little so that edges and highlights upon them are seen whole. */
const OFFSET = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 } as const
