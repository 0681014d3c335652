"""Sensors of a cell: what they measure, and what they tell of it."""
