"""Seen path: a path of the tool, given in one frame and expressed in another one."""

import numpy as np

from ropsim.motion.curves.grid import grid
from ropsim.motion.curves.path import ToolPath, ToolPoints
from ropsim.spatial import Array, Pose, record


@record
class Seen:
    """X_RT(s) = X_RP · X_PT(s), with a frame P that stands still in R.

    Attributes:
        path: in its own reference frame P.
        X_RP: that frame in the one from which the path is seen.
    """

    path: ToolPath
    X_RP: Pose

    @property
    def length(self) -> float:
        """Return the length of the path."""
        return self.path.length

    def own_grid(self) -> Array:
        """Return the grid of the path, shape (m,)."""
        return grid(self.path)

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""
        points, R = self.path.tool(s), self.X_RP.rotation()
        turned = (
            np.asarray((rows.reshape(-1, 2, 3) @ R.T).reshape(-1, 6)) for rows in (points.d1, points.d2)
        )
        return ToolPoints(self.X_RP.matrix() @ points.matrices, *turned)

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        return np.asarray(self.path.positions(s) @ self.X_RP.rotation().T + self.X_RP.position)

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the path of the TCP, shape (k,) [m]."""
        return self.path.distance((points - self.X_RP.position) @ self.X_RP.rotation())
