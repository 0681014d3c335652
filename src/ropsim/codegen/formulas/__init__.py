"""Formulas: traced expressions, straight-line source, and what depends on given numbers alone."""
