"""Choice of the blends of a motion sequence: by the limits of the tool first, then by joint limits."""

from collections.abc import Sequence

from ropsim.motion import Ticks
from ropsim.planning.blends.blend import Blend
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.retiming import Retiming, retimed
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.stops.quicker_stops import Times, can_stop, quicker_stops, without
from ropsim.planning.stops.sequence_times import arm_times, times_alone, tool_times
from ropsim.planning.trajectory.sections import TimingRules, sections_of
from ropsim.planning.trajectory.segments import JoinedSegments, segments_of
from ropsim.planning.trajectory.timing import Timing, timing_of
from ropsim.spatial import record

Blends = Sequence[Blend | None]


@record
class ByTool:
    """The quickest blends by the limits of the tool.

    Attributes:
        stops: numbers of points that became stops.
        blends: that are left.
        timing: of the sequence with them.
        alone: times that the moves take from rest to rest, at least [s].
        times: of moves from rest to rest with the blends between them.
    """

    stops: tuple[int, ...]
    blends: Blends
    timing: Timing
    alone: tuple[float, ...]
    times: Times


@record
class ByJoints:
    """The quickest blends by the limits of tool and joints.

    Attributes:
        stops: numbers of points that became stops for the joints.
        blends: that are left.
        retiming: the motion with them.
    """

    stops: tuple[int, ...]
    blends: Blends
    retiming: Retiming


def by_tool(
    moves: Sequence[PlannedMove], blends: Blends, joined: Sequence[JoinedSegments], rules: TimingRules
) -> ByTool:
    """Return which blends are quicker than stops by the limits of the tool.

    Args:
        moves: the moves.
        blends: between each two of them.
        joined: the segments of the moves with these blends, as from `segments_of`.
        rules: time law and look-ahead.
    """
    stops: tuple[int, ...] = ()
    parts = sections_of(joined, rules)
    alone, times = times_alone(moves, parts, rules), tool_times(moves, blends, rules)
    timing = timing_of(parts, len(moves))
    while more := quicker_stops(blends, timing.ends, alone, times):
        blends, stops = without(blends, more), (*stops, *more)
        timing = timing_of(sections_of(segments_of(moves, blends), rules), len(moves))
    return ByTool(stops, blends, timing, alone, times)


def by_joints(
    moves: Sequence[PlannedMove], chosen: ByTool, arm: ArmBounds, ticks: Ticks, rules: TimingRules
) -> ByJoints:
    """Return which of the blends that are left are quicker than stops within the limits of the joints.

    Retiming a whole sequence can be slightly slower than retiming its parts. So stops at all points are also
    tried if they might be quicker.

    Args:
        moves: the moves.
        chosen: blends that the limits of the tool leave.
        arm: limits of the joints.
        ticks: of control.
        rules: time law and look-ahead.
    """

    def retimed_with(blends: Blends) -> Retiming:
        timing = timing_of(sections_of(segments_of(moves, blends), rules), len(moves))
        return retimed(timing, arm, ticks, rules)

    blends = chosen.blends
    stops: tuple[int, ...] = ()
    retiming = retimed(chosen.timing, arm, ticks, rules)
    times = arm_times(moves, blends, rules, chosen.times, arm, ticks)
    while more := quicker_stops(blends, retiming.ends, chosen.alone, times):
        blends, stops = without(blends, more), (*stops, *more)
        retiming = retimed_with(blends)
    rounded = tuple(number for number, blend in enumerate(blends) if can_stop(blend))
    if rounded and retiming.duration > sum(chosen.alone):
        nowhere = without(blends, rounded)
        if (stopping := retimed_with(nowhere)).duration < retiming.duration:
            return ByJoints((*stops, *rounded), nowhere, stopping)
    return ByJoints(stops, blends, retiming)
