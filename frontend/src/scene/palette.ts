/** Colours of the stage beside those of the bodies; taken from the page's style sheet where it has them. */
import { Color } from 'three'
import type { Theme } from './settings'

export interface Palette {
  /** Background, from the upper to the lower end. */
  readonly top: Color
  readonly bottom: Color
  /** Edges of bodies, and their strength on shaded surfaces. */
  readonly ink: Color
  readonly inkStrength: number
  /** How dark shadows on the floor are, 0 … 1. */
  readonly shade: number
  readonly grid: Color
  readonly accent: Color
  readonly ghost: Color
  readonly jogged: Color
  readonly attained: Color
  readonly command: Color
  /** Bodies that collide. */
  readonly collision: Color
}

type Colours = Record<Exclude<keyof Palette, 'inkStrength' | 'shade'>, string>

const SHADE: Record<Theme, number> = { light: 0.3, dark: 0.5, print: 0.28 }

const INK_STRENGTH: Record<Theme, number> = { light: 0.45, dark: 0.55, print: 0.6 }

const DEFAULTS: Record<Exclude<Theme, 'print'>, Colours> = {
  light: {
    top: '#dfe6ee',
    bottom: '#f7f9fb',
    ink: '#1d2733',
    grid: '#5d6f84',
    accent: '#0b63c5',
    ghost: '#1f86e0',
    jogged: '#c2570c',
    attained: '#c01f5b',
    command: '#0b6fae',
    collision: '#c8211a',
  },
  dark: {
    top: '#2b333f',
    bottom: '#161a21',
    ink: '#05070a',
    grid: '#8fa3bb',
    accent: '#5cb0ff',
    ghost: '#5cc4ff',
    jogged: '#ffa14d',
    attained: '#ffd04d',
    command: '#6fd0ff',
    collision: '#ff6a5e',
  },
}

const PAPER: Colours = { ...DEFAULTS.light, top: '#ffffff', bottom: '#ffffff', grid: '#8796a6' }

/** Names of the custom properties that override the defaults. */
const PROPERTIES: Partial<Colours> = {
  top: '--scene-top',
  bottom: '--scene-bottom',
  grid: '--scene-grid',
  accent: '--accent',
}

/** The palette of a theme as the style sheet at `host` has it. */
export function paletteOf(theme: Theme, host: HTMLElement): Palette {
  const probe = document.createElement('span')
  host.append(probe)
  const defaults = theme === 'print' ? PAPER : DEFAULTS[theme]
  const colour = (name: keyof Colours) => {
    // Paper is white whatever the page is.
    const property = theme === 'print' ? undefined : PROPERTIES[name]
    return property ? asShown(probe, property, defaults[name]) : new Color(defaults[name])
  }
  const palette = {
    top: colour('top'),
    bottom: colour('bottom'),
    ink: colour('ink'),
    inkStrength: INK_STRENGTH[theme],
    shade: SHADE[theme],
    grid: colour('grid'),
    accent: colour('accent'),
    ghost: colour('ghost'),
    jogged: colour('jogged'),
    attained: colour('attained'),
    command: colour('command'),
    collision: colour('collision'),
  }
  probe.remove()
  return palette
}

/** A custom property worked out by the browser, whatever its notation; else the fallback. */
function asShown(probe: HTMLElement, property: string, fallback: string): Color {
  probe.style.color = `var(${property}, ${fallback})`
  const shown = getComputedStyle(probe).color
  // Any other notation would make three.js warn on the console.
  return new Color(/^rgb\([\d\s,]+\)$/.test(shown) ? shown : fallback)
}
