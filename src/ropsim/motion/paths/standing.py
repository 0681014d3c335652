"""Standing: the tool keeps its pose while something else moves."""

import numpy as np

from ropsim.motion.curves.path import ToolPoints
from ropsim.spatial import Array, Pose, record


@record
class Standing:
    """X(s) = X at every path parameter: only the axes that accompany the path move.

    Attributes:
        X: of the tool in the reference frame.
        length: of the path of those axes, in a unit of its own; positive.
    """

    X: Pose
    length: float = 1.0

    @property
    def moves(self) -> None:
        """Return that the path parameter is neither an arc length nor an angle of the tool."""

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""
        matrices = np.empty((len(s), 4, 4))
        matrices[:] = self.X.matrix()
        return ToolPoints(matrices, np.zeros((len(s), 6)), np.zeros((len(s), 6)))

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        positions = np.empty((len(s), 3))
        positions[:] = self.X.position
        return positions

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the TCP, shape (k,) [m]."""
        return np.asarray(np.linalg.norm(points - self.X.position, axis=1))
