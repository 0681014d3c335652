"""From Python functions to machine code that Python calls: numba's stages, object files, the door."""
