"""SWI-Prolog for WebAssembly in this process: the run time of emscripten, answered out of memory."""
