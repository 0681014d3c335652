"""How long moves of a sequence take from rest to rest: at least, by limits of the tool, and within all."""

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np

from ropsim.motion import PathLimits, Ticks, own_law_of
from ropsim.planning.blends.blend import Blend
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.retiming import retimed
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.stops.quicker_stops import Stretch, Times
from ropsim.planning.trajectory.sections import Section, TimingRules, sections_of
from ropsim.planning.trajectory.segments import segments_of
from ropsim.planning.trajectory.timing import Timing, timing_of


def times_alone(
    moves: Sequence[PlannedMove], parts: Sequence[Section], rules: TimingRules
) -> tuple[float, ...]:
    """Return the times that moves take from rest to rest by the limits of their paths [s].

    Amid a curve of moves there is no stop: infinity stands for the time of a move there.

    Args:
        moves: the moves.
        parts: of the moves with blends between them.
        rules: time law and look-ahead.
    """
    found: dict[int, float] = {}
    for part in parts:
        for path_segment in part.path_segments:
            number, path = path_segment.move_number, moves[path_segment.move_number].joints
            if path_segment.ends or path is None:
                continue
            if len(part.path_segments) == 1 and path_segment.joints is path:
                found[number] = part.law.duration
            elif path_segment.is_even:
                found[number] = _even_time(path_segment.path_limits, path.length, rules)
    for number, move in enumerate(moves):
        if own := own_law_of(move.joints):
            found[number] = own.duration
        elif move.on_curve and not (move.on_curve.is_first or move.on_curve.is_last):
            found[number] = inf
        elif number not in found:
            found[number] = _timing([replace(move, on_curve=None)], [], rules).duration
    return tuple(found[number] for number in range(len(moves)))


def _even_time(path_limits: PathLimits, length: float, rules: TimingRules) -> float:
    """Return the time [s] along a path of a length with the same bounds all along it."""
    rows = np.array([[length, *path_limits.bounds[0].tolist(), 1.0, -1.0]])
    return rules.law(rows, np.ones(1)).duration


def tool_times(moves: Sequence[PlannedMove], blends: Sequence[Blend | None], rules: TimingRules) -> Times:
    """Return the times of moves by the limits of their paths alone.

    Args:
        moves: the moves.
        blends: between each two of them.
        rules: time law and look-ahead.
    """
    known: dict[Stretch, float] = {}

    def time(span: Stretch) -> float:
        if span not in known:
            known[span] = _timing(*_part(moves, blends, span), rules).duration
        return known[span]

    return Times(time, time)


def arm_times(
    moves: Sequence[PlannedMove],
    blends: Sequence[Blend | None],
    rules: TimingRules,
    least: Times,
    arm: ArmBounds,
    ticks: Ticks,
) -> Times:
    """Return the times of moves within the limits of the joints.

    Args:
        moves: the moves.
        blends: between each two of them.
        rules: time law and look-ahead.
        least: their times by the limits of their paths.
        arm: limits of the joints.
        ticks: of control.
    """

    def time(span: Stretch) -> float:
        timing = _timing(*_part(moves, blends, span), rules)
        return retimed(timing, arm, ticks, rules).duration

    return Times(least.exact, time)


def _part(
    moves: Sequence[PlannedMove], blends: Sequence[Blend | None], span: Stretch
) -> tuple[Sequence[PlannedMove], Sequence[Blend | None]]:
    first, last = span
    return moves[first:last], blends[first : last - 1]


def _timing(moves: Sequence[PlannedMove], blends: Sequence[Blend | None], rules: TimingRules) -> Timing:
    return timing_of(sections_of(segments_of(moves, blends), rules), len(moves))
