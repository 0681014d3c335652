"""Whether closed chains let a motion of the axes through: where they lock, and whether they stay assembled.

Positions of closed chains are those of the assembly at home, followed along the straight way of the axes
from there. A chain that is followed along a motion may come to another assembly than that, if the motion goes
round a place where two of them meet; poses would then be of the one, and the arm in the other.
"""

from enum import Enum

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.kinematics.chain.arrays import joint_rows
from ropsim.kinematics.chain.closed_arrays import closed_arrays
from ropsim.kinematics.chain.closure import closed_states, states_along
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.model import Mechanism

SAME = 1e-6
"""Coordinates that differ by less are those of one assembly [rad | m]."""


class Obstacle(Enum):
    """What ends the passage of closed chains."""

    LOCKED = "locked"
    ANOTHER_ASSEMBLY = "another assembly"


@frozen_dataclass
class LoopPassage:
    """How far closed chains follow rows of axes.

    Attributes:
        rows: that they follow, from the first one on.
        obstacle: what ends the passage; None where they follow all rows.
    """

    rows: int
    obstacle: Obstacle | None = None


def loop_passage(mechanism: Mechanism, Q: npt.ArrayLike) -> LoopPassage:
    """Return how far the closed chains of a mechanism follow a motion of its axes.

    Args:
        mechanism: with n axes.
        Q: coordinates of the axes along the motion, without NaN [rad | m], shape (k, n).

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    linear, rows = without_linear_loops(mechanism), joint_rows(mechanism, Q)
    if not linear.cuts or not len(rows):
        return LoopPassage(len(rows))
    loops = closed_arrays(linear)
    home, results = closed_states(loops, rows)
    if results[0, 0] < 1.0:
        return LoopPassage(0, Obstacle.LOCKED)
    along, results = states_along(loops, rows, home[0])
    locked = np.flatnonzero(results[:, 0] < 1.0)
    end = int(locked[0]) if len(locked) else len(rows)
    apart = np.flatnonzero(~(np.abs(along[:end] - home[:end]).max(axis=1) < SAME))
    if len(apart):
        return LoopPassage(int(apart[0]), Obstacle.ANOTHER_ASSEMBLY)
    return LoopPassage(end, Obstacle.LOCKED if len(locked) else None)
