"""Blends that are slower than a stop become stops."""
