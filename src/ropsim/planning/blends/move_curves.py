"""Curves of moves: chains of short lines are compressed, and the curves are followed by the joints."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ropsim.model import ShortLines
from ropsim.motion import CurvePart, JointPath, JointPoints, StraightPart, compressed, end_of
from ropsim.planning.blends.joined_ends import SAME_JOINTS, joined_to
from ropsim.planning.blends.short_line_chains import MoveRange, chains_of, longest_on_curve, points_of
from ropsim.planning.moves.move_curve import MoveCurve, OnCurve
from ropsim.planning.moves.path_following import follow_path
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain

_SURELY_QUICKER = 10
"""Moves of a curve from which on it is quicker than a zone at each of their points."""


class _Ends(NamedTuple):
    """Where a curve begins and ends on the lines before and behind it.

    Attributes:
        before: length on the line before [m], 0 where it begins at the first point.
        behind: length on the line behind [m], 0 where it ends at the last point.
    """

    before: float
    behind: float


def with_curves(chain: MotionChain, moves: Sequence[PlannedMove]) -> list[PlannedMove]:
    """Return moves of which chains of short lines are on curves that take the place of their paths.

    A curve that the joints cannot follow is left out: its moves keep their own paths.

    Args:
        chain: the entities.
        moves: the moves, from rest to rest.
    """
    found = list(moves)
    if chain.controller.look_ahead.moves < 1 or chain.controller.short_lines is ShortLines.ZONES:
        return found
    for first, last in chains_of(chain, moves):
        here = moves[first:last]
        parts = compressed(*points_of(chain, here), longest_on_curve(here)).parts
        lines = {part.number: part for part in parts if isinstance(part, StraightPart)}
        for part in parts:
            if isinstance(part, StraightPart):
                continue
            before, behind = lines.get(part.first - 1), lines.get(part.last)
            ends = _Ends(before.end if before else 0.0, behind.begin if behind else 0.0)
            span = first + part.first, first + part.last
            if curve := _followed(chain, moves, span, part, ends):
                for index, number in enumerate(range(*span)):
                    found[number] = replace(moves[number], on_curve=OnCurve(curve, index))
    return found


def may_be_slower(moves: Sequence[PlannedMove]) -> bool:
    """Return whether a motion with curves may be slower than with a zone at each point.

    That happens where curves are short, since their ends cost more than the corners between.

    Args:
        moves: with curves.
    """
    firsts = [move.on_curve.curve for move in moves if move.on_curve and move.on_curve.is_first]
    return any(curve.moves < _SURELY_QUICKER for curve in firsts)


def _followed(
    chain: MotionChain, moves: Sequence[PlannedMove], span: MoveRange, part: CurvePart, ends: _Ends
) -> MoveCurve | None:
    """Return a curve of moves with its path in joint space; None if the joints cannot follow it.

    Args:
        chain: the entities.
        moves: the moves.
        span: of them on the curve.
        part: the curve.
        ends: where it begins and ends on the lines next to it.
    """
    first, last = span
    starts_on = moves[first - 1] if ends.before else moves[first]
    ends_on = moves[last] if ends.behind else moves[last - 1]
    assert starts_on.joints is not None
    assert ends_on.joints is not None
    start = starts_on.joints.length - ends.before if ends.before else 0.0
    begin = starts_on.joints.joints(np.array((start,)))
    traced = follow_path(chain, part.curve, begin.q[0], moves[first].move)
    if isinstance(traced, Refusal):
        return None
    joints: JointPath | None = traced[0]
    end = ends_on.joints.joints(np.array((ends.behind if ends.behind else ends_on.joints.length,)))
    if np.abs(end_of(traced[0]) - end.q[0]).max() > SAME_JOINTS:
        joints = _joined(chain, part, traced[0], (begin, end), ends, moves[first])
    if joints is None:
        return None
    return MoveCurve(part.curve, joints, part.parameters, ends.before, ends.behind, part.deviation, part.turn)


def _joined(
    chain: MotionChain,
    part: CurvePart,
    joints: JointPath,
    on_lines: tuple[JointPoints, JointPoints],
    ends: _Ends,
    move: PlannedMove,
) -> JointPath | None:
    """Return the path of the joints along a curve, ending where the moves behind it begin.

    Args:
        chain: the entities.
        part: the curve.
        joints: its path in joint space, followed from its begin.
        on_lines: the paths of the moves at its begin and its end.
        ends: where it begins and ends on the lines next to it.
        move: one of its moves.
    """
    own = joints.joints(np.array((0.0, part.curve.length)))
    begin, end = (
        there if on_line else JointPoints(there.q, own.d1[k : k + 1], own.d2[k : k + 1])
        for k, (there, on_line) in enumerate(zip(on_lines, (ends.before, ends.behind), strict=True))
    )
    return joined_to(chain, part.curve, joints, (begin, end), move.planned, None)
