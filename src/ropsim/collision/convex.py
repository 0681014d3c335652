"""Convex bodies, between which distances are computed."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array, Pose, frozen, record


@record
class Convex:
    """The convex hull of corners, or of circles about its own z axis, with all points within a margin.

    Attributes:
        points: corners (x, y, z), or circles (radius, height, 0) where it is round [m], shape (k, 3).
        is_round: whether it is the hull of circles.
        margin: so far around the hull it reaches [m].
        X_BC: its frame in that of the body that it belongs to.
    """

    points: Array
    is_round: bool
    margin: float
    X_BC: Pose

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", frozen(self.points))

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Return the least and greatest x, y, z in its own frame [m], shape (3,) each."""
        if not self.is_round:
            return self.points.min(axis=0) - self.margin, self.points.max(axis=0) + self.margin
        widest, heights = self.points[:, 0].max(), self.points[:, 1]
        high = np.array([widest, widest, heights.max()])
        return np.array([-widest, -widest, heights.min()]) - self.margin, high + self.margin

    def farthest(self, direction: Array) -> Array:
        """Return a point of the hull that lies farthest in a direction of its own frame, shape (3,)."""
        if not self.is_round:
            return np.asarray(self.points[int(np.argmax(self.points @ direction))])
        across = float(np.hypot(direction[0], direction[1]))
        radius, height, _ = self.points[int(np.argmax(self.points @ [across, direction[2], 0.0]))]
        side = direction[:2] / across if across > 0.0 else np.zeros(2)
        return np.array([*(radius * side), height])


def hull_of(corners: npt.ArrayLike, pose: Pose, margin: float = 0.0) -> Convex:
    """Return the convex hull of corners [m], shape (k, 3).

    Args:
        corners: in the frame of the hull.
        pose: X_BC of that frame.
        margin: so far around it the body reaches [m].
    """
    return Convex(frozen(corners), is_round=False, margin=margin, X_BC=pose)


def turned(circles: Sequence[tuple[float, float]], pose: Pose) -> Convex:
    """Return the convex hull of circles (radius, height) about z [m].

    Args:
        circles: one at least.
        pose: X_BC of the frame whose z they lie about.
    """
    points = frozen([(radius, height, 0.0) for radius, height in circles])
    return Convex(points, is_round=True, margin=0.0, X_BC=pose)
