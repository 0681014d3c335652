"""Efforts of a file that cannot carry the weight of the arm: such an axis has no limit of effort."""

from collections.abc import Sequence
from math import pi

import numpy as np

from ropsim.exchange.assembly.description import Connection
from ropsim.exchange.losses.diagnostics import WEAK_EFFORT
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.notes import Notes
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array

POSTURES = 128
"""Number of postures in which the weight is computed."""
_TURN = 2.0 * pi  # rad, of a joint that turns without end
_SPREAD = 0.7548776662466927  # inverse of the plastic number: its powers spread points evenly (Roberts 2018)

_WEAK = Topic(
    WEAK_EFFORT,
    "efforts",
    "the greatest efforts in the file cannot carry the weight of the arm at joints {}: no such limit is used",
    "compare efforts and masses with the data sheet",
)


def weak_axes(robot: RobotModel, driven: Sequence[Connection], notes: Notes) -> tuple[int, ...]:
    """Return the axes whose effort does not hold the arm in each posture within its limits (noted).

    Args:
        robot: with masses.
        driven: connection of each axis.
        notes: for the finding.
    """
    from ropsim.dynamics import gravity_loads

    efforts = np.array([joint.max_effort for joint in robot.axis_joints])
    if not np.isfinite(efforts).any():
        return ()
    loads = np.abs(gravity_loads(robot, _postures(robot))).max(axis=0)
    weak = tuple(np.flatnonzero(loads > efforts).tolist())
    for axis in weak:
        one = driven[axis]
        unit = "N" if robot.axis_joints[axis].type is JointType.PRISMATIC else "N·m"
        figures = (
            f"`{shown(one.name)}` has {efforts[axis]:.4g} {unit}, its weight needs {loads[axis]:.4g} {unit}"
        )
        notes.gather(_WEAK, one.span, [one.name], figures)
    return weak


def _postures(robot: RobotModel) -> Array:
    """Return postures that fill the limits of the axes evenly, shape (k, n)."""
    lower = np.array([joint.lower for joint in robot.axis_joints])
    upper = np.array([joint.upper for joint in robot.axis_joints])
    wide = upper - lower > _TURN
    middle = np.where(wide & (lower < 0.0) & (upper > 0.0), 0.0, (lower + upper) / 2.0)
    half = np.where(wide, _TURN / 2.0, (upper - lower) / 2.0)
    steps = _SPREAD ** np.arange(1, robot.n + 1)
    shares = (0.5 + np.outer(np.arange(POSTURES), steps)) % 1.0
    return np.asarray(middle + (2.0 * shares - 1.0) * half)
