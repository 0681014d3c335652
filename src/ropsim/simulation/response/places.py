"""Places over the ranges of the joints at which the loops of an arm are judged."""

from math import inf, pi

import numpy as np

from ropsim.dynamics import mass_matrices
from ropsim.model import JointType, Linkage, RobotModel
from ropsim.spatial import Array, frozen, record

MOST_PLACES = 45
"""Of a grid; each is judged with each load."""
_COUNTS = (1, 3, 5, 7, 9)
_PROBES = 9
_SAME = 0.01
"""Share by which an axis changes inertias or levers from which on it matters."""


@record
class PlaceGrid:
    """A grid over the ranges of those axes that change how an arm moves.

    Attributes:
        counts: places along each axis, ends of its range and evenly between; 1 for its middle, shape (n,).
        Q: coordinates of the places [rad | m], the last axis changes fastest, shape (k, n).
    """

    counts: tuple[int, ...]
    Q: Array


def place_grid(robot: RobotModel, most: int = MOST_PLACES) -> PlaceGrid:
    """Return a grid with more places along the axes that change inertias and levers more.

    An axis counts by the logarithm of the ratio in which the diagonal of the mass matrix, or its own lever,
    changes over its range while the others are in the middle.

    Args:
        robot: with drives.
        most: places at the most.
    """
    lower, upper = _ranges(robot)
    weights = np.array([_weight(robot, lower, upper, axis) for axis in range(robot.n)])
    steps = [0] * robot.n
    while True:
        counts = np.array([_COUNTS[step] for step in steps])
        longer = np.array([_COUNTS[min(step + 1, len(_COUNTS) - 1)] for step in steps])
        fits = (longer > counts) & (weights > _SAME) & (np.prod(counts) * longer <= most * counts)
        if not fits.any():
            break
        steps[int(np.argmax(np.where(fits, weights / counts, -inf)))] += 1
    lines = [
        np.linspace(first, last, count) if count > 1 else np.array([0.5 * (first + last)])
        for first, last, count in zip(lower, upper, counts, strict=True)
    ]
    meshes = np.meshgrid(*lines, indexing="ij")
    return PlaceGrid(
        tuple(int(one) for one in counts), frozen(np.stack([one.ravel() for one in meshes], axis=1))
    )


def _ranges(robot: RobotModel) -> tuple[Array, Array]:
    """Return the ends of the ranges; of an axis that turns further than once one turn about its middle."""
    lower, upper = np.array(robot.lower_limits), np.array(robot.upper_limits)
    endless = ~np.isfinite(upper - lower)
    lower[endless], upper[endless] = -pi, pi
    middle = 0.5 * (lower + upper)
    turns = np.array([joint.measure is JointType.REVOLUTE for joint in robot.axis_joints])
    wide = turns & (upper - lower > 2.0 * pi)
    return np.where(wide, middle - pi, lower), np.where(wide, middle + pi, upper)


def _weight(robot: RobotModel, lower: Array, upper: Array, axis: int) -> float:
    """Return how much an axis changes inertias and its lever, as the logarithm of a ratio."""
    Q = np.tile(0.5 * (lower + upper), (_PROBES, 1))
    Q[:, axis] = np.linspace(lower[axis], upper[axis], _PROBES)
    inertias = np.einsum("kii->ki", mass_matrices(robot, Q))
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = np.log(inertias.max(axis=0) / inertias.min(axis=0))
    found = float(np.nan_to_num(ratios).max())
    gear = robot.drives[axis].transmission
    if isinstance(gear, Linkage):
        levers = np.array([abs(gear.ratio_at(q)) for q in Q[:, axis].tolist()])
        found = max(found, 2.0 * float(np.log(levers.max() / max(levers.min(), 1e-9 * levers.max()))))
    return found
