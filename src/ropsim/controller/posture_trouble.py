"""What goes ill with a path of the tool in one posture and may go well in another."""

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.leg import Leg
from ropsim.flow import MoveInstruction
from ropsim.model import RobotModel
from ropsim.motion import JOINT_LIMIT_ON_LINE, JUMP_ON_LINE, durations
from ropsim.spatial import Array, record

WHIRL = 0.25
"""Share of its speed to which a path may be slowed by a joint before another posture is looked for."""

_STEPS = 64
"""Parts of a path of which each is looked at by the way of the joints on it."""
_TINY = 1e-300


@record
class Trouble:
    """A path that cannot be followed well.

    Attributes:
        number: of its move in the stretch.
        words: what and where.
    """

    number: int
    words: str


def trouble_of(robot: RobotModel, leg: Leg, number: int) -> Trouble | None:
    """Return where the joints whirl on the path of a move, None where they do not.

    Args:
        robot: the arm.
        leg: the move, with a path of the tool.
        number: of the move in the stretch.
    """
    own, needs = _times(robot, leg)
    shares = own / np.maximum(needs.max(axis=1), own)
    part = int(np.argmin(shares))
    if not shares[part] < WHIRL:
        return None
    joint = robot.axis_joints[int(np.argmax(needs[part]))]
    words = f"joint `{joint.name}` slows the path down to {shares[part]:.0%} of its speed"
    return Trouble(number, f"{_place(leg.move)}{words} after {part / _STEPS:.0%} of it")


def trouble_of_refusal(move: MoveInstruction, refusal: Refusal, number: int) -> list[Trouble]:
    """Return why a path cannot be followed, nothing where no other posture would help.

    Args:
        move: that is refused.
        refusal: of it.
        number: of the move in the stretch.
    """
    codes = {JOINT_LIMIT_ON_LINE.code, JUMP_ON_LINE.code}
    return [
        Trouble(number, f"{_place(move)}{found.message}")
        for found in refusal.diagnostics[:1]
        if found.code in codes
    ]


def time_of(robot: RobotModel, leg: Leg, q_start: Array) -> float:
    """Return the time of a move [s], without that for changes of speed on a path of the tool.

    Args:
        robot: the arm.
        leg: the move.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
    """
    if leg.joints is None:
        return 0.0
    if leg.tool is None:
        return float(durations(q_start, leg.q_end[np.newaxis], leg.planned.limits.joints)[0])
    own, needs = _times(robot, leg)
    return float(np.maximum(needs.max(axis=1), own).sum())


def _times(robot: RobotModel, leg: Leg) -> tuple[Array, Array]:
    """Return the times [s] of the parts of a path: of the tool, shape (k,), and of the joints, (k, n)."""
    assert leg.tool is not None
    assert leg.joints is not None
    places = np.linspace(0.0, leg.tool.length, _STEPS + 1)
    step, d1, limits = leg.tool.length / _STEPS, leg.tool.tool(places).d1, leg.planned.limits.tool
    slowness = np.maximum(
        np.linalg.norm(d1[:, :3], axis=1) / max(limits.speed, _TINY),
        np.linalg.norm(d1[:, 3:], axis=1) / max(limits.orientation_speed, _TINY),
    )
    ways = np.abs(np.diff(leg.joints.joints(places).q, axis=0))
    return step * np.maximum(slowness[:-1], slowness[1:]), ways / robot.max_speeds


def _place(move: MoveInstruction) -> str:
    span = move.origin.span
    return f"line {span.line}: " if span else ""
