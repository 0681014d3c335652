"""Closed chains: rows of the cuts, what is fastened where, and the solver of motion under constraints."""
