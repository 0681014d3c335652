"""Bounds of speed, acceleration and jerk along a path, by its derivatives."""
