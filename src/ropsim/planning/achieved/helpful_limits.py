"""Which limits of the path would make a slow move quicker: it is planned again with each of them raised."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from ropsim.flow import LimitQuantity
from ropsim.motion import JointSection, RetimedTrajectory, Ticks, ToolLimits, ToolSection
from ropsim.planning.blends.blend import Blend
from ropsim.planning.blends.short_line_chains import longest_on_curve
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.retiming import retimed
from ropsim.planning.moves.move_curve import MoveCurve, OnCurve
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.trajectory.sections import TimingRules, sections_of
from ropsim.planning.trajectory.segments import segments_of
from ropsim.planning.trajectory.timing import timing_of
from ropsim.spatial import frozen

_RAISED = 2.0
"""Factor of a limit that is raised."""
_WORTH = 0.1
"""Share of the time lost that a limit has to save to help."""
_MINOR = 1.0 / 3.0
"""Share of what the most helpful limit saves below which another one is not named."""
_AROUND = 3
"""Moves before and behind that are planned with a move."""
_MOST_ON_CURVE = 60
"""The same on a curve, where the tool may not be at its speed after a few of them."""


class AchievedMotion(NamedTuple):
    """A motion sequence as it is achieved.

    Attributes:
        moves: the moves.
        blends: between each two of them; None where the arm stops.
        arm: limits of the joints.
        ticks: of control.
        rules: time law and look-ahead.
    """

    moves: Sequence[PlannedMove]
    blends: Sequence[Blend | None]
    arm: ArmBounds
    ticks: Ticks
    rules: TimingRules


def helpful_limits(
    achieved: AchievedMotion, number: int, lost: Mapping[int, float]
) -> tuple[LimitQuantity, ...]:
    """Return the limits of the path that make a move quicker when they are raised, the most helpful first.

    Acceleration and jerk are doubled for the move and for those around it, one alone and then both: two help
    together where none does alone. The moves around it that are slow for the same cause count with it. Limits
    of the joints stay as they are, so that nothing is named that they would take back.

    Args:
        achieved: the sequence of the move.
        number: of the move in it.
        lost: time that moves lose that are slow for the cause of this one, by their numbers [s].
    """
    first, last = _around(achieved, number)
    counted = [one - first for one in lost if first <= one < last]
    whole = sum(lost[first + one] for one in counted)
    moves, blends = _on_part(achieved.moves[first:last]), achieved.blends[first : last - 1]

    def time(*raised: LimitQuantity) -> float:
        return _time(achieved, [_with_raised(one, raised) for one in moves], blends, counted)

    now, both = time(), (LimitQuantity.ACCELERATION, LimitQuantity.JERK)
    saved: Mapping[LimitQuantity, float] = {one: now - time(one) for one in both}
    most = max(saved.values())
    if most >= _WORTH * whole:
        helping = [one for one in both if saved[one] >= _MINOR * most]
        return tuple(sorted(helping, key=lambda one: -saved[one]))
    return both if now - time(*both) >= _WORTH * whole else ()


def _around(achieved: AchievedMotion, number: int) -> tuple[int, int]:
    """Return the moves to plan with one: up to stops and the ends of curves, few, or room to speed up."""
    moves, blends, first, last = achieved.moves, achieved.blends, number, number + 1
    curve = on.curve if (on := moves[number].on_curve) else None
    room = longest_on_curve(moves[number:last])

    def goes_on(inner: int, outer: int) -> bool:
        """Return whether the part goes on from its move at an end to the one beyond."""
        if not 0 <= outer < len(moves) or blends[min(inner, outer)] is None:
            return False
        other = on.curve if (on := moves[outer].on_curve) else None
        between = moves[min(inner, number) : max(inner, number) + 1]
        way = sum(one.joints.length for one in between if one.joints)
        return other is curve and len(between) <= (_MOST_ON_CURVE if curve and way < room else _AROUND)

    while goes_on(first, first - 1):
        first -= 1
    while goes_on(last - 1, last):
        last += 1
    return first, last


def _on_part(moves: Sequence[PlannedMove]) -> Sequence[PlannedMove]:
    """Return moves on one curve as on the part of it that is theirs; others unchanged."""
    if not (on := moves[0].on_curve):
        return moves
    curve, whole = on.curve, on.curve.parameters[on.index : on.index + len(moves) + 1]
    begin, end = float(whole[0]), float(whole[-1])
    tool, joints = ToolSection(curve.tool, begin, end), JointSection(curve.joints, begin, end)
    part = MoveCurve(tool, joints, frozen(whole - begin), 0.0, 0.0, curve.deviation, curve.turn)
    return [replace(move, on_curve=OnCurve(part, index)) for index, move in enumerate(moves)]


def _with_raised(move: PlannedMove, raised: Sequence[LimitQuantity]) -> PlannedMove:
    if not raised:
        return move
    limits = move.planned.limits
    tool: ToolLimits = limits.tool
    more = {one.value: getattr(tool, one.value) * _RAISED for one in raised}
    return replace(move, planned=replace(move.planned, limits=replace(limits, tool=replace(tool, **more))))


def _time(
    achieved: AchievedMotion,
    moves: Sequence[PlannedMove],
    blends: Sequence[Blend | None],
    counted: Sequence[int],
) -> float:
    """Return how long some of the moves take, of all from rest to rest [s]."""
    timing = timing_of(sections_of(segments_of(moves, blends), achieved.rules), len(moves))
    ends = timing.ends
    found = retimed(timing, achieved.arm, achieved.ticks, achieved.rules)
    if isinstance(found.retimed, RetimedTrajectory):
        ends = found.ends
    begins = (0.0, *ends)
    return sum(ends[one] - begins[one] for one in counted)
