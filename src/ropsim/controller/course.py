"""The course of a stretch: runs of pieces, each walked from rest to rest, one overlapping the next."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.controller.coordination import Coordination
from ropsim.controller.corners import Corner, Overlap, Rounding
from ropsim.controller.leg import Leg
from ropsim.controller.stages import Stages, along_with, joint_stages, tool_stages
from ropsim.motion import (
    JointPath,
    JointSection,
    Stage,
    SynchronisedJoints,
    TimeLaw,
    ToolLimits,
    ToolPath,
    ToolSection,
    plan_time_law,
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
        tool: its path of the tool, in the base frame or that of the coordination; None where it has none.
        X_MT: the tool.
        stages: bounds along it, part by part; none where it has a time law of its own.
        corner: that it leads round; None for a part of the path of a move.
        coordination: external axes that go along with the path of the tool; None where they stand.
        begin: place at which it begins on the path of its move, in the unit of that; 0 for a corner.
    """

    leg: int
    joints: JointPath
    tool: ToolPath | None
    X_MT: Pose
    stages: Stages
    corner: Rounding | None = None
    coordination: Coordination | None = None
    begin: float = 0.0


@record
class Run:
    """Pieces that are walked together from rest to rest.

    Attributes:
        pieces: in order.
        law: when the motion is where on them; it counts pieces, whatever the stages of each.
        start: motion time at which it begins [s].
        overlap: for how long the run before still lasts then [s].
    """

    pieces: tuple[Piece, ...]
    law: TimeLaw
    start: float
    overlap: float

    @property
    def end(self) -> float:
        """Return the motion time at which it ends [s]."""
        return self.start + self.law.duration


@record
class Course:
    """All runs of a stretch.

    Attributes:
        runs: in order; none where nothing moves.
        ends: motion times at which the moves end [s]: in the middle of their corners, or where they stop.
    """

    runs: tuple[Run, ...]
    ends: tuple[float, ...]

    @property
    def duration(self) -> float:
        """Return the motion time from start to end [s]."""
        return self.runs[-1].end if self.runs else 0.0


def course_of(legs: Sequence[Leg], corners: Sequence[Corner | None], look_ahead: int) -> Course:
    """Return the course through moves.

    Args:
        legs: the moves.
        corners: between each two of them; None where the arm stops there, or where one has no length.
        look_ahead: how many moves beyond the present one are known.
    """
    runs: list[Run] = []
    overlap: Overlap | None = None
    for pieces, corner in _runs(legs, corners):
        law = _law(pieces, look_ahead)
        before = runs[-1] if runs else None
        both = 0.0
        if before and overlap:
            last = len(before.pieces) - 1
            leave = overlap.leave - before.pieces[last].begin
            ends = before.law.duration - float(before.law.times_of(last, np.array([leave]))[0])
            both = min(ends, float(law.times_of(0, np.array([overlap.enter]))[0]))
        start = before.end - both if before else 0.0
        runs.append(Run(tuple(pieces), law, start, both))
        overlap = corner
    return Course(tuple(runs), tuple(_ends(runs, len(legs))))


def _runs(legs: Sequence[Leg], corners: Sequence[Corner | None]) -> list[tuple[list[Piece], Overlap | None]]:
    """Return the pieces of each run, and how it goes over into the next one; None where it stops."""
    runs: list[tuple[list[Piece], Overlap | None]] = []
    pieces: list[Piece] = []
    enters = 0.0
    for number, leg in enumerate(legs):
        corner = corners[number] if number < len(corners) else None
        if leg.joints is None:
            continue
        leaves = corner.leave if isinstance(corner, Rounding) else leg.joints.length
        if leaves - enters > _NOTHING * leg.joints.length:
            pieces.append(_straight(number, leg, enters, leaves))
        if isinstance(corner, Rounding):
            pieces.append(_round(number, leg, legs[number + 1], corner))
            enters = corner.enter
        else:
            runs.append((pieces, corner))
            pieces, enters = [], 0.0
    return runs


def _ends(runs: Sequence[Run], legs: int) -> list[float]:
    ends = [0.0] * legs
    for place, run in enumerate(runs):
        behind = runs[place + 1] if place + 1 < len(runs) else None
        for number, piece in enumerate(run.pieces):
            if piece.corner:
                middle = run.law.times_of(number, np.array([piece.joints.length / 2.0]))
                ends[piece.leg] = run.start + float(middle[0])
        ends[run.pieces[-1].leg] = run.end - (0.5 * behind.overlap if behind else 0.0)
    for leg in range(1, legs):
        ends[leg] = max(ends[leg], ends[leg - 1])
    return ends


def _law(pieces: Sequence[Piece], look_ahead: int) -> TimeLaw:
    """Return the time law of a run: planned stage by stage, told piece by piece."""
    alone = pieces[0].joints
    if isinstance(alone, SynchronisedJoints):
        return alone.law
    law = plan_time_law(_with_horizons(pieces, look_ahead))
    counts = [len(piece.stages) for piece in pieces]
    return law if max(counts) == 1 else law.in_parts(counts)


def _with_horizons(pieces: Sequence[Piece], look_ahead: int) -> list[Stage]:
    """Return the stages of the pieces of a run, with the last stage that is known where a piece ends.

    Within a piece no more gets known: who can stop after it can stop before.
    """
    ends = np.cumsum([len(piece.stages) for piece in pieces]).tolist()
    last = {piece.leg: end - 1 for piece, end in zip(pieces, ends, strict=True)}
    final = pieces[-1].leg
    stages: list[Stage] = []
    for piece in pieces:
        stages += piece.stages
        stages[-1] = replace(stages[-1], horizon=last[min(piece.leg + look_ahead, final)])
    return stages


def _straight(number: int, leg: Leg, first: float, last: float) -> Piece:
    assert leg.joints is not None
    whole = first == 0.0 and last == leg.joints.length
    joints = leg.joints if whole else JointSection(leg.joints, first, last)
    tool = leg.tool if whole or leg.tool is None else ToolSection(leg.tool, first, last)
    limits, coordination = leg.planned.limits, leg.planned.coordination
    if tool is None:
        stages = () if isinstance(joints, SynchronisedJoints) else joint_stages(joints, limits.joints)
        return Piece(number, joints, None, leg.planned.X_MT, stages, begin=first)
    if coordination and not whole:
        coordination = coordination.part(first, last)
    stages = along_with(tool_stages(tool, limits.tool), coordination)
    return Piece(number, joints, tool, leg.planned.X_MT, stages, coordination=coordination, begin=first)


def _round(number: int, before: Leg, behind: Leg, corner: Rounding) -> Piece:
    one, other = before.planned.limits.tool, behind.planned.limits.tool
    least = ToolLimits(*(min(getattr(one, name), getattr(other, name)) for name in ToolLimits.__slots__))
    stages, X_MT = along_with(tool_stages(corner.tool, least), corner.coordination), before.planned.X_MT
    return Piece(number, corner.joints, corner.tool, X_MT, stages, corner, corner.coordination)
