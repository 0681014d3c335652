"""Path velocity characteristics on the part of a move at constant speed."""

import math

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array

PLATEAU = 0.99
"""Share of the largest commanded speed from which on a sample belongs to the plateau."""
STANDSTILL = 1e-3
"""Commanded speed below which a move has no plateau [m/s]."""


@frozen_dataclass
class SpeedFigures:
    """Figures of one pass, ISO 9283:1998, 8.6; NaN without a part at constant speed.

    Attributes:
        command: mean commanded speed there [m/s].
        accuracy: AV = (mean attained speed − command speed) / command speed, a share.
        fluctuation: FV, largest minus least attained speed [m/s].
    """

    command: float = math.nan
    accuracy: float = math.nan
    fluctuation: float = math.nan


def speed_figures(command: Array, attained: Array) -> SpeedFigures:
    """Return AV and FV of a move.

    They are taken over the middle half of the samples in which the commanded speed is within 1 % of its
    largest value.

    Args:
        command: speeds of the commanded tool centre point [m/s], shape (k,).
        attained: of the attained one, alike.
    """
    if not np.any(np.isfinite(command)) or float(np.nanmax(command)) < STANDSTILL:
        return SpeedFigures()
    plateau = np.flatnonzero(command >= PLATEAU * np.nanmax(command))
    quarter = plateau.size // 4
    middle = plateau[quarter : plateau.size - quarter]
    wanted = float(np.mean(command[middle]))
    accuracy = float(np.mean(attained[middle])) / wanted - 1.0
    return SpeedFigures(wanted, accuracy, float(np.ptp(attained[middle])))
