"""The course of a stretch: the paths of its moves and the ways round its corners, one behind the other."""

from collections.abc import Sequence

import numpy as np

from ropsim.controller.corners import Rounding
from ropsim.controller.leg import Leg
from ropsim.controller.stages import joint_stage, tool_stage
from ropsim.controller.stretch_motion import StretchMotion
from ropsim.motion import (
    JointMotionLimits,
    JointPath,
    JointSection,
    LineLimits,
    Stage,
    TimeLaw,
    ToolPath,
    ToolSection,
)
from ropsim.spatial import Pose, record

_NOTHING = 1e-9
"""Share of a path below which nothing is left of it between two corners."""


@record
class Piece:
    """A part of the course.

    Attributes:
        leg: number of the move that it belongs to; a corner belongs to the move before it.
        joints: its path in joint space.
        tool: its path of the tool; None where it has none.
        X_MT: the tool.
        stage: bounds along it.
        corner: that it leads round; None for a part of the path of a move.
    """

    leg: int
    joints: JointPath
    tool: ToolPath | None
    X_MT: Pose
    stage: Stage
    corner: Rounding | None = None


@record
class Course:
    """All pieces of a stretch, in order.

    Attributes:
        pieces: of moves that have a length, and corners.
        legs: how many moves there are.
    """

    pieces: tuple[Piece, ...]
    legs: int

    def motion(self, law: TimeLaw) -> StretchMotion:
        """Return the motion of a time law along the course."""
        return StretchMotion(tuple(piece.joints for piece in self.pieces), law)

    def stages(self, look_ahead: int) -> tuple[Stage, ...]:
        """Return the bounds of all pieces; so many moves beyond the present one are known."""
        last = [0] * (self.legs + 1)
        for number, piece in enumerate(self.pieces):
            last[piece.leg] = number
        for leg in range(1, self.legs + 1):
            last[leg] = max(last[leg], last[leg - 1])
        horizons = [last[min(piece.leg + look_ahead, self.legs - 1)] for piece in self.pieces]
        return tuple(
            _with_horizon(piece.stage, horizon) for piece, horizon in zip(self.pieces, horizons, strict=True)
        )

    def ends_of_moves(self, law: TimeLaw) -> list[float]:
        """Return the motion times at which moves end [s]: in the middle of corners, or where they stop."""
        ends = [0.0] * self.legs
        for number, piece in enumerate(self.pieces):
            if piece.corner:
                ends[piece.leg] = float(law.times_of(number, np.array([piece.joints.length / 2.0]))[0])
            else:
                ends[piece.leg] = float(law.ends[number])
        for leg in range(1, self.legs):
            ends[leg] = max(ends[leg], ends[leg - 1])
        return ends


def course_of(legs: Sequence[Leg], corners: Sequence[Rounding | None]) -> Course:
    """Return the course through moves.

    Args:
        legs: the moves.
        corners: between each two of them; None where the arm stops there, or where one has no length.
    """
    pieces: list[Piece] = []
    ratio = 0.0
    for number, leg in enumerate(legs):
        before = corners[number - 1] if number else None
        behind = corners[number] if number < len(corners) else None
        if leg.joints is None:
            continue
        first = before.enter if before else 0.0
        last = behind.leave if behind else leg.joints.length
        if last - first > _NOTHING * leg.joints.length:
            pieces.append(_straight(number, leg, first, last, ratio))
            ratio = 1.0
        if behind:
            pieces.append(_corner(number, leg, legs[number + 1], behind, ratio * behind.before))
            ratio = behind.behind
        else:
            ratio = 0.0
    return Course(tuple(pieces), len(legs))


def _straight(number: int, leg: Leg, first: float, last: float, ratio: float) -> Piece:
    assert leg.joints is not None
    whole = first == 0.0 and last == leg.joints.length
    joints = leg.joints if whole else JointSection(leg.joints, first, last)
    tool = leg.tool if whole or leg.tool is None else ToolSection(leg.tool, first, last)
    limits = leg.planned.limits
    stage = joint_stage(joints, limits.joints) if tool is None else tool_stage(tool, limits.tool)
    return Piece(number, joints, tool, leg.planned.X_MT, _with_ratio(stage, ratio))


def _corner(number: int, before: Leg, behind: Leg, corner: Rounding, ratio: float) -> Piece:
    one, other = before.planned.limits, behind.planned.limits
    if corner.tool is None:
        stage = joint_stage(corner.joints, _both_joints(one.joints, other.joints))
    else:
        stage = tool_stage(corner.tool, _both_tool(one.tool, other.tool))
    return Piece(number, corner.joints, corner.tool, before.planned.X_MT, _with_ratio(stage, ratio), corner)


def _both_joints(one: JointMotionLimits, other: JointMotionLimits) -> JointMotionLimits:
    names = ("speed", "acceleration", "jerk")
    return JointMotionLimits(*(np.minimum(getattr(one, name), getattr(other, name)) for name in names))


def _both_tool(one: LineLimits, other: LineLimits) -> LineLimits:
    names = LineLimits.__slots__
    return LineLimits(*(min(getattr(one, name), getattr(other, name)) for name in names))


def _with_ratio(stage: Stage, ratio: float) -> Stage:
    return Stage(stage.length, stage.speed, stage.acceleration, stage.jerk, ratio)


def _with_horizon(stage: Stage, horizon: int) -> Stage:
    return Stage(stage.length, stage.speed, stage.acceleration, stage.jerk, stage.ratio, horizon)
