// Animation frames for tests: Node has none, and a timer of one test may ask for one after its stub has gone.
globalThis.requestAnimationFrame ??= () => 0
globalThis.cancelAnimationFrame ??= () => undefined
