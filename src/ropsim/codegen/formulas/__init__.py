"""Formulas: traced expressions, straight-line source, and parts that depend on given numbers alone."""
