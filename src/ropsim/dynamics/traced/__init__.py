"""Equations of motion as straight-line formulas of one structure."""
