"""Paths of the joints over the length of a path."""
