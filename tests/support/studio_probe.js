// Notes when things happen on the page of the studio. Runs before the page's own scripts.
window.__probe = (() => {
  const probe = {
    /** Times since the page was asked for [ms]. */
    picture: null,
    editor: null,
    /** First findings of the language server. */
    checked: null,
    /** State frames of live runs: how many, how large, and their age one animation frame after they were drawn [ms]. */
    frames: 0,
    bytes: 0,
    largest: 0,
    ages: [],
    /** Longest time between two states that follow one another, when they were sent [ms]. */
    gap: 0,
    /** From a key to the change of the marks in the editor, and to its stamp by the simulator [ms]. */
    marks: [],
    stamps: [],
    /** From a slider to the answer of the kinematics [ms]. */
    jogs: [],
    reset() {
      Object.assign(probe, { frames: 0, bytes: 0, largest: 0, ages: [], gap: 0, marks: [], stamps: [], jogs: [] })
    },
  }
  let newest = 0
  let drawn = 0
  let shown = 0
  let watching = false
  let key = null
  let pressed = null
  let moved = null
  let marked = 0

  function received(data) {
    if (data instanceof ArrayBuffer) {
      probe.frames += 1
      probe.bytes += data.byteLength
      probe.largest = Math.max(probe.largest, data.byteLength)
      const sent = new DataView(data).getFloat64(16, true)
      if (probe.frames > 1) probe.gap = Math.max(probe.gap, sent - newest)
      newest = sent
      if (!watching) requestAnimationFrame(watch)
      watching = true
      return
    }
    if (data.includes('publishDiagnostics')) probe.checked ??= performance.now()
    if (moved !== null && data.startsWith('{"type":"jogged"')) {
      probe.jogs.push(performance.now() - moved)
      moved = null
    }
    if (pressed !== null && data.startsWith('{"type":"stamped"')) {
      probe.stamps.push(performance.now() - pressed)
      pressed = null
    }
  }

  // What came before an animation frame is drawn in it. When the next one begins, the browser has taken it over.
  function watch() {
    if (drawn !== shown) probe.ages.push(Date.now() - drawn)
    shown = drawn
    watching = drawn !== newest
    drawn = newest
    if (watching) requestAnimationFrame(watch)
  }

  const Native = window.WebSocket
  window.WebSocket = class extends Native {
    constructor(...args) {
      super(...args)
      this.addEventListener('message', event => received(event.data))
    }
  }

  function changed() {
    if (probe.picture === null && document.body?.dataset.ready !== undefined) probe.picture = performance.now()
    if (probe.editor === null && document.querySelector('.cm-line')?.textContent) probe.editor = performance.now()
    const count = document.querySelectorAll('.cm-lintRange-error').length
    if (key !== null && count !== marked) {
      probe.marks.push(performance.now() - key)
      key = null
    }
    marked = count
  }

  new MutationObserver(changed).observe(document, { childList: true, subtree: true, attributeFilter: ['data-ready'] })
  addEventListener('keydown', () => { key = pressed = performance.now() }, true)
  addEventListener('input', event => { if (event.target.type === 'range') moved = performance.now() }, true)
  return probe
})()
