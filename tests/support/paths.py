"""What tests of paths share: random poses, derivatives by differences of a path's own poses."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from ropsim.motion import JointPath, ToolPath
from ropsim.spatial import Array, Pose

_SIDES: Array = np.array([-2.0, -1.0, 1.0, 2.0])
_WEIGHTS: Array = np.array([1.0, -8.0, 8.0, -1.0]) / 12.0  # central difference of order 4


def random_pose(rng: np.random.Generator, size: float = 1.0) -> Pose:
    """Return a pose whose coordinates are about `size` [m], turned anyhow."""
    return Pose(rng.normal(size=3) * size, rng.normal(size=4))


def inner_places(length: float, count: int = 23) -> Array:
    """Return places of a path, away from both ends, shape (count,)."""
    return np.linspace(0.01, 0.99, count) * length


def difference(rows: Callable[[Array], Array], s: Array, step: float) -> Array:
    """Return the derivative of rows by central differences of order 4."""
    return np.asarray(sum(w * rows(s + side * step) for side, w in zip(_SIDES, _WEIGHTS, strict=True)) / step)


def tool_differences(path: ToolPath, s: Array, step: float) -> tuple[Array, Array]:
    """Return d1 from the poses of a path, and d2 from its d1, each (k, 6), by central differences."""
    middle = path.tool(s).matrices

    def coordinates(places: Array) -> Array:
        matrices = path.tool(places).matrices
        turned = matrices[:, :3, :3] @ np.swapaxes(middle[:, :3, :3], 1, 2)
        return np.hstack((matrices[:, :3, 3], Rotation.from_matrix(turned).as_rotvec()))

    return difference(coordinates, s, step), difference(lambda places: path.tool(places).d1, s, step)


def joint_differences(path: JointPath, s: Array, step: float) -> tuple[Array, Array]:
    """Return d1 from the coordinates of a path, and d2 from its d1, each (k, n), by central differences."""
    return (
        difference(lambda places: path.joints(places).q, s, step),
        difference(lambda places: path.joints(places).d1, s, step),
    )


def brute_distances(path: ToolPath, points: Array, count: int = 20_001) -> Array:
    """Return the least distance of points, shape (k, 3), to many positions of a path, shape (k,)."""
    way = path.positions(np.linspace(0.0, path.length, count))
    return np.array([np.sqrt(np.square(way - point).sum(axis=1).min()) for point in points])
