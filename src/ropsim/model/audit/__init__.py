"""Doubtful numbers of a model that can still be computed with."""
