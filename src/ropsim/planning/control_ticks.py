"""A motion in control ticks: references, and the ticks at which moves, path segments and triggers come."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ropsim.core import Diagnostic, maker
from ropsim.flow import JointReference, ReachedSpeed
from ropsim.motion import JointPoints, RetimedTrajectory, Ticks, ToolPath, ToolSection
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.motion_plan import MotionPlan, TimedMove, TimedSegment
from ropsim.planning.records.trigger_ticks import AchievedPath, PlannedTrigger, trigger_ticks
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.planning.trajectory.timing import Timing
from ropsim.planning.trajectory.timing_kernel import ticks_come
from ropsim.spatial import Array

_SLACK = 1e-9
"""Share of a control tick by which a motion may be longer than whole ticks, for rounding."""
_MOVES = 64
"""Moves of a curve that are one piece of its path in the plan."""
_MARGIN = 0.05
"""Length by which a piece reaches beyond its moves [m]; arms lag by less behind their references."""
_move, _path_segment = maker(TimedMove), maker(TimedSegment)


def standing(
    planned_moves: Sequence[PlannedMove], q_start: Array, period: float, findings: Sequence[Diagnostic]
) -> MotionPlan:
    """Return the plan of moves that all end where they begin.

    Args:
        planned_moves: the moves.
        q_start: command joint coordinates [rad | m], shape (n,).
        period: time of a control tick [s].
        findings: on the moves.
    """
    moves = tuple(TimedMove(move.move, move.planned.X_MT, move.q_end, 0, 0.0) for move in planned_moves)
    nothing = JointReference(*(np.empty((0, len(q_start))) for _ in range(3)))
    return MotionPlan(moves, (), q_start, nothing, period, tuple(findings))


def in_ticks(
    chain: MotionChain,
    planned_moves: Sequence[PlannedMove],
    zones: Sequence[float],
    timing: Timing,
    retimed: RetimedTrajectory,
    reached: Mapping[int, ReachedSpeed],
    findings: Sequence[Diagnostic],
) -> MotionPlan:
    """Return the plan of a motion; it takes over the rows of the motion and writes its end there.

    Args:
        chain: the entities, with the control period.
        planned_moves: the moves.
        zones: that are flown at their ends [m].
        timing: of the sequence.
        retimed: its motion within the limits of the joints, at all control ticks until it rests.
        reached: the moves that are slower than programmed, by their numbers.
        findings: on the moves.
    """
    period, phi = chain.controller.rates.control_period, retimed.phi[1:]
    reference = _to_rest(retimed.rows, planned_moves[-1].q_end, Ticks(period).count(retimed.clock.duration))
    at, ends = (
        np.empty((len(timing.path_segment_ends) + len(timing.sections), 2)),
        np.empty(len(planned_moves) - 1),
    )
    reference = chain.fine(reference, retimed.rows.q[0], chain.controller.rates)
    times = timing.table, timing.path_segment_ends, np.array(timing.ends[:-1]), phi, _SLACK * period
    ticks_come(*times, at[: len(timing.path_segment_ends)], at[len(timing.path_segment_ends) :], ends)
    lasts = [0, *map(int, ends.tolist()), reference.ticks]
    moves, found = [], list(findings)
    for number, (planned_move, zone) in enumerate(zip(planned_moves, zones, strict=True)):
        first, last = lasts[number : number + 2]
        planned, move = planned_move.planned, planned_move.move
        X_MT = planned.X_MT
        triggers: tuple[PlannedTrigger, ...] = ()
        if move.triggers:
            along, q = planned.coordination, reference.q[max(first - 1, 0) : last]
            q = np.concatenate((retimed.rows.q[:1], q)) if first == 0 else q
            achieved = AchievedPath(chain.robot, X_MT, q, along.frame if along else None)
            triggers, result = trigger_ticks(move, achieved, first, period)
            found += result
        of_tool = planned.tool is not None
        limits, slow = planned.limits, reached.get(number)
        moves.append(_move(move, X_MT, planned_move.q_end, last, zone, triggers, limits, of_tool, slow))
    path_segments, blends = _path_segments(timing, at.astype(np.int64).tolist(), lasts)
    return MotionPlan(tuple(moves), path_segments, retimed.rows.q[0], reference, period, tuple(found), blends)


def _path_segments(
    timing: Timing, ticks: Sequence[Sequence[int]], lasts: Sequence[int]
) -> tuple[tuple[TimedSegment, ...], tuple[tuple[int, int], ...]]:
    """Return the path segments, and the blends and overlaps in order of time.

    Args:
        timing: of the sequence.
        ticks: the last one before each path segment, and the last one on it; behind these the same for the
            overlap of each section with the one before.
        lasts: tick at which the first move begins, then those at which the moves end.
    """
    path_segments, blends, number = list[TimedSegment](), list[tuple[int, int]](), 0
    for section in timing.sections:
        for path_segment in section.part.path_segments:
            (first, last), along = ticks[number], path_segment.coordination
            frame = along.frame if along else None
            path_segments += (
                _path_segment(tool, path_segment.X_MT, begin, end, frame)
                for tool, begin, end in _by_moves(path_segment, first, last, lasts)
            )
            if path_segment.blend is not None:
                blends.append((first, last))
            number += 1
    for section, (first, last) in zip(timing.sections, ticks[number:], strict=True):
        if section.overlap > 0.0:
            blends.append((first, last))
    return tuple(path_segments), tuple(sorted(blends))


def _by_moves(
    path_segment: PathSegment, first: int, last: int, lasts: Sequence[int]
) -> Iterator[tuple[ToolPath | None, int, int]]:
    """Yield the path of the tool of a segment in pieces of some moves, each with its ticks.

    A piece reaches beyond its ticks, since the arm lags behind its references; the search for the nearest
    place on it takes a time that does not depend on the length of the whole.

    Args:
        path_segment: of the timing.
        first: last tick before it.
        last: last tick on it.
        lasts: tick at which the first move begins, then those at which the moves end.
    """
    tool, ends, begin = path_segment.tool, path_segment.ends, 0.0
    if tool is not None:
        for index in range(_MOVES - 1, len(ends) - 1, _MOVES):
            tick = lasts[path_segment.move_number + index + 1]
            yield _with_margins(tool, begin, ends[index]), first, tick
            begin, first = ends[index], tick
    yield (tool if tool is None or not begin else _with_margins(tool, begin, tool.length)), first, last


def _with_margins(tool: ToolPath, begin: float, end: float) -> ToolPath:
    """Return the section of a path between two path parameters, and beyond both."""
    return ToolSection(tool, max(begin - _MARGIN, 0.0), min(end + _MARGIN, tool.length))


def _to_rest(rows: JointPoints, q_end: Array, at_rest: int) -> JointReference:
    """Return the reference of a motion: the rows are reused, since no other code needs them.

    The end is exact, without the rounding of sums.

    Args:
        rows: of the motion at the control ticks 0, 1, … until it rests.
        q_end: joint coordinates at its end [rad | m], shape (n,).
        at_rest: first control tick at which it is there.
    """
    rows.q[at_rest:], rows.d1[at_rest:], rows.d2[at_rest:] = q_end, 0.0, 0.0
    return JointReference(rows.q[1:], rows.d1[1:], rows.d2[1:])
