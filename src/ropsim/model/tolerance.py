"""Tolerances by which attained motion is judged against the limits of a model."""

SPEED_OVERSHOOT = 0.02
"""Share by which a servo may exceed a speed limit for a moment; more is a finding."""
