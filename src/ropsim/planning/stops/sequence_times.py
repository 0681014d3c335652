"""How long moves of a stretch take from rest to rest: at least, by limits of the tool, and within all."""

from collections.abc import Sequence

import numpy as np

from ropsim.motion import SynchronisedJoints, Ticks, rest_to_rest_times
from ropsim.planning.blends.blend import Corner
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.retiming import keeping_of
from ropsim.planning.moves.planned_move import Leg
from ropsim.planning.stops.quicker_stops import Span, Times
from ropsim.planning.trajectory.sections import Part, parts_of
from ropsim.planning.trajectory.segments import pieces_of
from ropsim.planning.trajectory.timing import Course, course_of


def times_alone(legs: Sequence[Leg], parts: Sequence[Part], look_ahead: int) -> tuple[float, ...]:
    """Return the times that moves take from rest to rest by the limits of their paths [s].

    Args:
        legs: the moves.
        parts: of the moves with corners between them.
        look_ahead: how many moves beyond the present one are known.
    """
    found, even = {}, {}
    for part in parts:
        for piece in part.pieces:
            if piece.corner is None and piece.is_even:
                if len(part.pieces) == 1 and piece.joints is legs[piece.leg].joints:
                    found[piece.leg] = part.law.duration
                else:
                    even[piece.leg] = piece.stages.rows
    lengths = {number: path.length for number in even if (path := legs[number].joints)}
    if lengths:
        rows = np.concatenate([even[number] for number in lengths])
        rows[:, 0] = tuple(lengths.values())
        found |= zip(lengths, rest_to_rest_times(rows).tolist(), strict=True)
    for number, leg in enumerate(legs):
        if isinstance(leg.joints, SynchronisedJoints):
            found[number] = leg.joints.length  # its parameter is the time
        elif number not in found:
            found[number] = _course([leg], [], look_ahead).duration
    return tuple(found[number] for number in range(len(legs)))


def tool_times(legs: Sequence[Leg], corners: Sequence[Corner | None], look_ahead: int) -> Times:
    """Return the times of moves by the limits of their paths alone.

    Args:
        legs: the moves.
        corners: between each two of them.
        look_ahead: how many moves beyond the present one are known.
    """
    known: dict[Span, float] = {}

    def time(span: Span) -> float:
        if span not in known:
            known[span] = _course(*_part(legs, corners, span), look_ahead).duration
        return known[span]

    return Times(time, time)


def arm_times(
    legs: Sequence[Leg],
    corners: Sequence[Corner | None],
    look_ahead: int,
    least: Times,
    arm: ArmBounds,
    ticks: Ticks,
) -> Times:
    """Return the times of moves within the limits of the joints.

    Args:
        legs: the moves.
        corners: between each two of them.
        look_ahead: how many moves beyond the present one are known.
        least: their times by the limits of their paths.
        arm: limits of the joints.
        ticks: of control.
    """

    def time(span: Span) -> float:
        course = _course(*_part(legs, corners, span), look_ahead)
        return keeping_of(course, arm, ticks, look_ahead).duration

    return Times(least.exact, time)


def _part(
    legs: Sequence[Leg], corners: Sequence[Corner | None], span: Span
) -> tuple[Sequence[Leg], Sequence[Corner | None]]:
    first, last = span
    return legs[first:last], corners[first : last - 1]


def _course(legs: Sequence[Leg], corners: Sequence[Corner | None], look_ahead: int) -> Course:
    return course_of(parts_of(pieces_of(legs, corners), look_ahead), len(legs))
