"""Tolerances by which attained motion is judged against the limits of a model."""

SPEED_OVERSHOOT = 0.02
"""Share by which a servo may exceed a speed limit for a moment; more is a finding."""

OVERRUN = 1e-4
"""How far a servo may overrun the limit of a joint that it stands at [rad | m]; more is a finding."""
