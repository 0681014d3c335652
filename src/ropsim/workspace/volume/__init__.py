"""The reachable volume: sweeps of the first axis, sheets, its section on a lattice, and its surface."""
