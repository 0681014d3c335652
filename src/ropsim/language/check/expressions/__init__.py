"""Expressions: syntax to typed values in SI units."""
