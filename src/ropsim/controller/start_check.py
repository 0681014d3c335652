"""What planning a stretch must be given: an arm that stands, with one coordinate for each axis."""

import math

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.motion_plan import MotionState
from ropsim.core import Severity, define
from ropsim.flow import MoveInstruction
from ropsim.model import RobotModel

NOT_AT_REST = define(
    "C605",
    "not-at-rest",
    Severity.ERROR,
    "a stretch is planned from a state in which the arm does not stand, or that is none",
    """
A stretch begins and ends at rest. `plan` was given speeds or accelerations other than 0, numbers that are not
finite, or another number of them than the robot has axes. The moves are not planned.

**How to mend it.** Plan from `MotionState.at_rest(q)`, with the joint coordinates at which the arm stands. A
motion that is under way is slowed, held and ended by the motion clock, not by planning it anew.
""",
)


def check_start(state: MotionState, robot: RobotModel, move: MoveInstruction) -> Refusal | None:
    """Return C605 where a motion cannot begin at a state, None where it can.

    Args:
        state: where the first move begins.
        robot: the arm.
        move: the first move.
    """
    rows = {"coordinates": state.q, "speeds": state.qd, "accelerations": state.qdd}
    for name, row in rows.items():
        values = np.asarray(row, dtype=np.float64)
        if values.shape != (robot.n,):
            return _refused(f"{name} of shape {values.shape}, allowed is ({robot.n},)", move)
        numbers = values.tolist()
        if not all(map(math.isfinite, numbers)):
            return _refused(f"{name} {numbers}, allowed are finite numbers", move)
        if name != "coordinates" and any(numbers):
            return _refused(f"{name} {numbers}, allowed are zeros", move)
    return None


def _refused(found: str, move: MoveInstruction) -> Refusal:
    return Refusal((NOT_AT_REST.at(move.origin.span, f"the motion is to begin with {found}"),))
