"""Closed chains: rows of the cuts, and the solver of motion under constraints."""
