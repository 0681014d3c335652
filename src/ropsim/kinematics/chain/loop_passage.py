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
from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays
from ropsim.kinematics.chain.closed_motion import joint_motion
from ropsim.kinematics.chain.closure import closed_states, states_along
from ropsim.kinematics.chain.closure_kernel import write_rows
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.model import (
    BASE_LINK,
    Mechanism,
    first_coordinates,
    joint_tree,
    loop_coordinates,
    passive_coordinates,
)
from ropsim.spatial import Array

MOVED = 1e-5
"""Bodies this far from their place in the assembly at home [m, entries of the rotation matrix] are in another
one: a chain that is closed to rounding is within 1e-7 of it next to a dead centre."""
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


@frozen_dataclass
class DeadCentre:
    """Where a closed chain does not say how it moves on.

    Attributes:
        chain: number of the cut, from 0.
        axis: number of the axis that cannot move on there, from 0.
        joint: number of the joint that moves while the axes stand.
        distance: smallest singular value of the slopes of the rows over the greatest one, 0 in a dead centre.
    """

    chain: int
    axis: int
    joint: int
    distance: float


def is_as_at_home(mechanism: Mechanism, state: Array) -> bool:
    """Return whether bodies are where they are in the assembly at home, with the axes at the same place.

    Args:
        mechanism: with closed chains.
        state: coordinates of axes and closed chains, closed, shape (n + p,) [rad | m].
    """
    loops, q = closed_arrays(mechanism), state[np.newaxis, : mechanism.n]
    linear = without_linear_loops(mechanism)
    if linear.cuts:
        found, results = closed_states(loops, q)
        if results[0, 0] < 1.0:  # so far only; next to a dead centre rounding decides whether to the end
            way = np.abs(q[0] - mechanism.home).max()
            return bool((1.0 - results[0, 0]) * way < MOVED)
        home = found[0]
    else:
        passive = joint_motion(linear, q).position[0, list(passive_coordinates(mechanism))]
        home = np.concatenate((q[0], passive))
    apart = _bodies(mechanism, loops, state) - _bodies(mechanism, loops, home)
    return bool(np.abs(apart).max(initial=0.0) < MOVED)


def dead_centre(mechanism: Mechanism, state: Array) -> DeadCentre:
    """Return which axis a closed chain holds at, or next to, a dead centre, and what moves instead.

    The slopes of the rows by the coordinates of the chains have a singular value of about 0 there. Its right
    vector is how they move while the axes stand; the axis that its left one weighs most is held.

    Args:
        mechanism: with closed chains.
        state: coordinates of axes and closed chains, closed, shape (n + p,) [rad | m].
    """
    loops, work = closed_arrays(mechanism), closed_arrays(mechanism).work()
    write_rows(loops.arm(), np.ascontiguousarray(state), work)
    slopes, n = work.slopes @ loops.spread[:, :-1], loops.n
    left, values, right = np.linalg.svd(slopes[:, n:], full_matrices=False)
    number = passive_coordinates(mechanism)[int(np.abs(right[-1]).argmax())]
    first = first_coordinates(mechanism.joints)
    chains = [k for k, cut in enumerate(mechanism.cuts) if number in loop_coordinates(mechanism, cut)]
    return DeadCentre(
        chains[0] if chains else 0,
        int(np.abs(left[:, -1] @ slopes[:, :n]).argmax()),
        int(np.searchsorted(first, number, side="right")) - 1,
        float(values[-1] / values[0]),
    )


def _bodies(mechanism: Mechanism, loops: ClosedArrays, state: Array) -> Array:
    """Return rotations and places of all bodies at a state (n + p,), shape (l, 12)."""
    work = loops.work()
    write_rows(loops.arm(), np.ascontiguousarray(state), work)
    carriers = [one for one in joint_tree(mechanism).carriers if one != BASE_LINK]
    return np.array(work.frames[carriers])


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
