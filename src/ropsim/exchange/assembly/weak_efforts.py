"""Efforts of a file that cannot carry the weight of the arm; they are not used as limits."""

from collections.abc import Sequence

import numpy as np

from ropsim.exchange.assembly.description import Connection
from ropsim.exchange.losses.diagnostics import WEAK_EFFORT
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.notes import Notes
from ropsim.model import JointType, RobotModel

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
    from ropsim.dynamics import greatest_gravity_loads

    efforts = np.array([joint.max_effort for joint in robot.axis_joints])
    if not np.isfinite(efforts).any():
        return ()
    loads = greatest_gravity_loads(robot)
    weak = tuple(np.flatnonzero(loads > efforts).tolist())
    for axis in weak:
        one = driven[axis]
        unit = "N" if robot.axis_joints[axis].type is JointType.PRISMATIC else "N·m"
        figures = (
            f"`{shown(one.name)}` has {efforts[axis]:.4g} {unit}, its weight needs {loads[axis]:.4g} {unit}"
        )
        notes.gather(_WEAK, one.span, [one.name], figures)
    return weak
