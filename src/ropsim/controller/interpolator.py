"""The interpolator: samples a path of the tool."""

import math

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import PoseSetpoints
from ropsim.motion import ToolPath
from ropsim.spatial import Array

FEWEST = 16
"""Steps of the shortest path."""


@frozen_dataclass
class StandardInterpolator:
    """Samples a path at equally spaced places, not further apart than a way and a turn of the tool.

    Attributes:
        way: longest way of the TCP between two samples [m].
        turn: largest turn of the tool between two samples [rad].
    """

    way: float = 0.01
    turn: float = math.radians(2.0)

    def sample(self, path: ToolPath, density: int) -> PoseSetpoints:
        """Return the poses of the tool, from the start of the path to its end.

        Args:
            path: of the tool.
            density: how many times more samples than at first.
        """
        looks = path.tool(_places(path.length, 4)).d1  # (5, 6)
        squares = np.add.reduce((looks * looks).reshape(-1, 2, 3), axis=2)
        way, turn = (np.sqrt(np.maximum.reduce(squares, axis=0)) * path.length).tolist()
        steps = density * max(FEWEST, math.ceil(way / self.way), math.ceil(turn / self.turn))
        return PoseSetpoints(path.length, path.tool(_places(path.length, steps)).matrices)


def _places(length: float, steps: int) -> Array:
    """Return the places between equal steps from 0 to a length, bit by bit as `numpy.linspace` does."""
    places = np.arange(steps + 1, dtype=np.float64) * (length / steps)
    places[-1] = length
    return np.asarray(places)
