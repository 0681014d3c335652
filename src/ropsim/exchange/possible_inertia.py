"""Inertias that other simulators take: they refuse moments that break A + B >= C."""

import numpy as np

from ropsim.spatial import Array

_SLACK = 1e-9


def possible_inertia(inertia: Array) -> Array:
    """Return an inertia itself where a body can have it, else one with smaller moments raised to A + B = C.

    Args:
        inertia: about the centre of mass [kg·m²], shape (3, 3).
    """
    moments, axes = np.linalg.eigh(inertia)
    raised = np.maximum(moments, 0.0)
    missing = float(raised[2] - raised[0] - raised[1])
    if missing <= _SLACK * raised[2] and moments[0] >= 0.0:
        return inertia
    if missing > 0.0:
        raised[:2] += missing / 2.0 * (1.0 + _SLACK)
    whole = axes @ np.diag(raised) @ axes.T
    return np.asarray((whole + whole.T) / 2.0)
