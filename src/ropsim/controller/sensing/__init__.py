"""Sensors of a cell: measured quantities and readings."""
