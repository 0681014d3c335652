"""Trees of bodies and joints with couplings and closed chains, and their checks."""
