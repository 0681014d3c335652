/** What the help panel says beside its pages. */
export const helpWords = {
  topics: { keys: 'Keys', language: 'Language', cell: 'Cell file', commands: 'Command line' },
  choose: 'What to show',
  search: 'Search',
  contents: 'Contents',
  none: 'Nothing here holds these words.',
  views: 'In a 3-D view',
  mouse: 'Mouse in a 3-D view',
  view: {
    fit: 'Fit what is selected',
    home: 'Fit all',
    sides: 'Front, right, top',
    perspective: 'Perspective',
    projection: 'Parallel or perspective projection',
    turn: 'Turn',
    shift: 'Shift',
    zoom: 'Nearer, farther',
    turnAbout: 'Turn about the point under the pointer',
    zoomTo: 'Towards the pointer and away',
  },
  editorKeys: 'Text editor',
  editor: {
    again: 'Find the next one, the one before',
    fold: 'Fold, unfold',
  },
  drag: { left: 'Left drag', right: 'Right drag, or Shift with left', wheel: 'Wheel' },
} as const
