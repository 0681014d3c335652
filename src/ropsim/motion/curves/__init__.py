"""Basics of paths: their protocols, polynomials, differences, distances and rotation vectors."""
