"""The interpolator: samples a path of the tool."""

import math

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import PoseSetpoints
from ropsim.motion import ToolPath

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
        ends = path.tool(np.linspace(0.0, path.length, 5)).d1  # (5, 6)
        way, turn = (
            float(np.linalg.norm(part, axis=1).max()) * path.length for part in (ends[:, :3], ends[:, 3:])
        )
        steps = density * max(FEWEST, math.ceil(way / self.way), math.ceil(turn / self.turn))
        return PoseSetpoints(path.length, path.tool(np.linspace(0.0, path.length, steps + 1)).matrices)
