/** Every visible or spoken text of the 3-D stage. */
export const words = {
  presets: {
    perspective: 'Perspective',
    top: 'Top',
    front: 'Front',
    right: 'Right',
    isometric: 'Isometric',
    custom: 'Custom',
  },
  projections: { perspective: 'Perspective', parallel: 'Parallel' },
  viewName: (preset: string) => `3-D view: ${preset}`,
  keys:
    'Arrow keys turn the view, Shift and arrow keys move it, plus and minus zoom, F fits the selection, Home fits ' +
    'all, 1 front, 3 right, 7 top, 0 perspective, 5 switches between perspective and parallel projection.',
  toolbar: (view: string) => `Settings of the ${view} view`,
  direction: 'Direction of view',
  projection: (now: string) => `Projection: ${now}. Switch (key 5)`,
  fit: 'Fit all into the view (Home)',
  noWebGL:
    'The 3-D views cannot be shown: this browser offers no WebGL 2. Switch on hardware acceleration or WebGL in the ' +
    'settings of the browser, or open the page in a current Firefox, Chrome, Edge or Safari. Everything else on this ' +
    'page works.',
  contextLost:
    'The graphics driver has stopped the 3-D views for a moment. They come back by themselves; if they do not, ' +
    'reload the page.',
  missingMesh: (file: string) => `⚠ ${file}`,
  meshFailed: (reason: string) => `could not be loaded (${reason})`,
}

export type Words = typeof words
