"""Checks of a diagram: names, sizes, wiring, numbers, units, loops."""
