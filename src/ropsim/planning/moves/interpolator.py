"""The interpolator: samples a path of the tool."""

import math

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import PoseSetpoints
from ropsim.motion import ToolPath
from ropsim.spatial import Array

FEWEST = 16
"""Steps of the shortest path."""
FEWEST_EXACT = 4
"""The same where the derivatives of the joints are known."""
SAMPLES = 4
"""Steps between the path parameters at which speed and rotation of a path are evaluated."""


@frozen_dataclass
class StandardInterpolator:
    """Samples a path at equal steps, no longer than a distance and a turn of the tool.

    Attributes:
        distance: longest distance of the TCP between two samples [m].
        turn: largest turn of the tool between two samples [rad].
    """

    distance: float = 0.01
    turn: float = math.radians(2.0)

    def sample(self, path: ToolPath, sampling: int) -> PoseSetpoints:
        """Return the poses of the tool, from the start of the path to its end.

        Args:
            path: of the tool.
            sampling: how many times more samples than at first.
        """
        return PoseSetpoints(
            path.length, path.tool(even_parameters(path.length, sampling * self.steps(path))).matrices
        )

    def sample_at(self, path: ToolPath, s: Array) -> PoseSetpoints:
        """Return the poses of the tool with their derivatives at path parameters.

        Args:
            path: of the tool.
            s: path parameters, rising from 0 to its length, shape (k,).
        """
        points = path.tool(s)
        derivatives = np.array((points.d1, points.d2))
        return PoseSetpoints(path.length, points.matrices, None, s, derivatives)

    def steps(self, path: ToolPath) -> int:
        """Return how many equal steps a path has at first."""
        return max(FEWEST, self._steps(path))

    def fewest_steps(self, path: ToolPath) -> int:
        """Return how many steps a path has at first where derivatives of the joints are known."""
        return max(FEWEST_EXACT, self._steps(path))

    def _steps(self, path: ToolPath) -> int:
        samples = path.tool(even_parameters(path.length, SAMPLES)).d1  # (5, 6)
        squares = np.add.reduce((samples * samples).reshape(-1, 2, 3), axis=2)
        distance, turn = (np.sqrt(np.maximum.reduce(squares, axis=0)) * path.length).tolist()
        return max(math.ceil(float(distance) / self.distance), math.ceil(float(turn) / self.turn))


def even_parameters(length: float, steps: int) -> Array:
    """Return path parameters at equal steps from 0 to a length, to the bit as `numpy.linspace`."""
    found = np.arange(steps + 1, dtype=np.float64) * (length / steps)
    found[-1] = length
    return np.asarray(found)
