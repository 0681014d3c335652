"""Where triggers act: at which control ticks of a plan outputs are set on the way of a move."""

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction, Side, Trigger
from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import TRIGGER_OFF_PATH
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.planning.records.wording import passes
from ropsim.spatial import Array, Pose, record

_SLACK = 1e-9
"""Rounding of a path that is added up [m], and of a time in ticks."""


@record
class PlannedTrigger:
    """An output that is set on the way.

    Attributes:
        trigger: the trigger.
        tick: control tick of the plan at which.
    """

    trigger: Trigger
    tick: int


@record
class AchievedPath:
    """The path of a move in control ticks.

    Attributes:
        robot: the arm.
        X_MT: the tool.
        q: references at the control ticks of the move, its start first [rad | m], shape (k + 1, n).
        frame: from which the path is seen where external axes move it; None for the base frame.
    """

    robot: RobotModel
    X_MT: Pose
    q: Array
    frame: MovingFrame | None = None

    def positions(self) -> Array:
        """Return the TCP at the control ticks in the frame [m], shape (k + 1, 3)."""
        positions = np.asarray((forward_batch(self.robot, self.q) @ self.X_MT.matrix())[:, :3, 3])
        return self.frame.positions(self.q, positions) if self.frame else positions


def trigger_ticks(
    move: MoveInstruction, achieved: AchievedPath, first: int, period: float
) -> tuple[tuple[PlannedTrigger, ...], tuple[Diagnostic, ...]]:
    """Return when the triggers of a move act, in order of time, and M565 for triggers outside its path.

    A distance is measured along the achieved path of the TCP, including blends, in the frame of its path; a
    move with a blend begins and ends in the middle of it. Outputs are set at the first control tick at which
    the TCP has come so far.

    Args:
        move: the instruction.
        achieved: its path.
        first: control tick of the plan at which the move starts.
        period: time of a control tick [s].
    """
    if not move.triggers:
        return (), ()
    steps = np.linalg.norm(np.diff(achieved.positions(), axis=0), axis=1)
    behind = np.concatenate(([0.0], np.cumsum(steps)))  # distance from the start [m], (k + 1,)
    planned, findings = [], []
    for trigger in move.triggers:
        covered, unit, size = (behind, "mm", trigger.distance)
        if size is None:
            covered, unit, size = np.arange(len(behind)) * period, "s", trigger.time or 0.0
        whole = float(covered[-1])
        wanted = size if trigger.side is Side.AFTER_START else whole - size
        if not -_SLACK <= wanted <= whole + _SLACK:
            findings.append(_off_path(move, trigger, size, whole, unit))
        tick = min(int(np.searchsorted(covered, wanted - _SLACK)), len(behind) - 1)
        planned.append(PlannedTrigger(trigger, first + tick))
    return tuple(sorted(planned, key=lambda one: one.tick)), tuple(findings)


def _off_path(move: MoveInstruction, trigger: Trigger, size: float, whole: float, unit: str) -> Diagnostic:
    end = "start" if trigger.side is Side.BEFORE_END else "end"
    side = "before the end" if trigger.side is Side.BEFORE_END else "after the start"
    scale = 1e3 if unit == "mm" else 1.0
    return TRIGGER_OFF_PATH.at(
        move.origin.span,
        f"`{trigger.channel}` is to be set {size * scale:g} {unit} {side}, the move is "
        f"{whole * scale:.4g} {unit} long: it is set at its {end}",
        label=passes(move.origin),
        hint="give less, or put it on the move beside this one",
        data={"wanted": size, "whole": whole, **move.origin.data},
    )
