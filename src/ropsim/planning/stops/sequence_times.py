"""How long moves of a sequence take from rest to rest: at least, by limits of the tool, and within all."""

from collections.abc import Sequence

import numpy as np

from ropsim.motion import PathLimits, Ticks, own_law_of
from ropsim.planning.blends.blend import Blend
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.retiming import retimed
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.stops.quicker_stops import Span, Times
from ropsim.planning.trajectory.sections import Section, TimingRules, sections_of
from ropsim.planning.trajectory.segments import segments_of
from ropsim.planning.trajectory.timing import Timing, timing_of


def times_alone(
    legs: Sequence[PlannedMove], parts: Sequence[Section], rules: TimingRules
) -> tuple[float, ...]:
    """Return the times that moves take from rest to rest by the limits of their paths [s].

    Args:
        legs: the moves.
        parts: of the moves with corners between them.
        rules: time law and look-ahead.
    """
    found: dict[int, float] = {}
    for part in parts:
        for piece in part.pieces:
            path = legs[piece.leg].joints
            if piece.corner is not None or path is None or not piece.is_even:
                continue
            is_whole = len(part.pieces) == 1 and piece.joints is path
            found[piece.leg] = part.law.duration if is_whole else _even_time(piece.stages, path.length, rules)
    for number, leg in enumerate(legs):
        if own := own_law_of(leg.joints):
            found[number] = own.duration
        elif number not in found:
            found[number] = _course([leg], [], rules).duration
    return tuple(found[number] for number in range(len(legs)))


def _even_time(stages: PathLimits, length: float, rules: TimingRules) -> float:
    """Return the time [s] along a path of a length with the same bounds all along it."""
    rows = np.array([[length, *stages.bounds[0].tolist(), 1.0, -1.0]])
    return rules.law(rows, np.ones(1)).duration


def tool_times(legs: Sequence[PlannedMove], corners: Sequence[Blend | None], rules: TimingRules) -> Times:
    """Return the times of moves by the limits of their paths alone.

    Args:
        legs: the moves.
        corners: between each two of them.
        rules: time law and look-ahead.
    """
    known: dict[Span, float] = {}

    def time(span: Span) -> float:
        if span not in known:
            known[span] = _course(*_part(legs, corners, span), rules).duration
        return known[span]

    return Times(time, time)


def arm_times(
    legs: Sequence[PlannedMove],
    corners: Sequence[Blend | None],
    rules: TimingRules,
    least: Times,
    arm: ArmBounds,
    ticks: Ticks,
) -> Times:
    """Return the times of moves within the limits of the joints.

    Args:
        legs: the moves.
        corners: between each two of them.
        rules: time law and look-ahead.
        least: their times by the limits of their paths.
        arm: limits of the joints.
        ticks: of control.
    """

    def time(span: Span) -> float:
        course = _course(*_part(legs, corners, span), rules)
        return retimed(course, arm, ticks, rules).duration

    return Times(least.exact, time)


def _part(
    legs: Sequence[PlannedMove], corners: Sequence[Blend | None], span: Span
) -> tuple[Sequence[PlannedMove], Sequence[Blend | None]]:
    first, last = span
    return legs[first:last], corners[first : last - 1]


def _course(legs: Sequence[PlannedMove], corners: Sequence[Blend | None], rules: TimingRules) -> Timing:
    return timing_of(sections_of(segments_of(legs, corners), rules), len(legs))
