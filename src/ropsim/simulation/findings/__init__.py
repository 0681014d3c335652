"""Findings of a run as a whole."""
