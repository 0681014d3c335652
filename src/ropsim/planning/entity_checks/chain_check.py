"""Closed chains along a move of the joints: whether they follow to its end."""

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import LOOP_CHANGES, LOOP_LOCKS, Obstacle, loop_passage
from ropsim.model import RobotModel
from ropsim.motion import JointPath
from ropsim.planning.records.wording import passes

STEP = 0.02
"""Longest way of an axis between two places that are looked at [rad | m]."""


def chain_refusals(move: MoveInstruction, robot: RobotModel, path: JointPath) -> tuple[Diagnostic, ...]:
    """Return M556 where a closed chain locks on the way, M557 where it would change its assembly.

    Args:
        move: along the path.
        robot: the arm.
        path: of its axes.
    """
    if not robot.cuts:
        return ()
    ends = path.joints(np.array([0.0, path.length])).q
    count = 2 + int(np.abs(ends[1] - ends[0]).max() / STEP)
    rows = path.joints(np.linspace(0.0, path.length, count)).q
    found = loop_passage(robot, rows)
    if found.obstacle is None:
        return ()
    share, origin = found.rows / (count - 1), move.origin
    if found.obstacle is Obstacle.LOCKED:
        kind, words = LOOP_LOCKS, "a closed chain locks"
    else:
        kind, words = LOOP_CHANGES, "a closed chain would come to another assembly"
    finding = kind.at(
        origin.span,
        f"{words} at {share:.0%} of the way",
        label=passes(origin),
        hint="give a point on the way round, or use `lin`",
        data={"share": share, **origin.data},
    )
    return (finding,)
