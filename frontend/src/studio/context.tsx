/** The studio of the page, for components. */
import { createContext, useContext } from 'react'
import { useStore } from 'zustand'
import type { StudioState } from './state'
import type { Studio } from './studio'

export const StudioContext = createContext<Studio | null>(null)

export function useStudio(): Studio {
  const studio = useContext(StudioContext)
  if (!studio) throw new Error('a panel stands outside of the studio')
  return studio
}

/** A piece of the rare state; the component is drawn again when it changes. */
export function useStudioState<T>(selector: (state: StudioState) => T): T {
  return useStore(useStudio().store, selector)
}
