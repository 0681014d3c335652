"""A motion in control ticks: references, and the ticks at which moves, pieces and triggers come."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.controller.blends import blend_ticks
from ropsim.controller.course import Course
from ropsim.controller.leg import Leg
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.motion_plan import MotionPlan, PlannedMove, PlannedPiece
from ropsim.controller.trigger_ticks import Flown, PlannedTrigger, trigger_ticks
from ropsim.core import Diagnostic
from ropsim.flow import JointReference
from ropsim.motion import JointPoints, Kept
from ropsim.spatial import Array

_SLACK = 1e-9
"""Share of a control tick by which a motion may be longer than whole ticks, for rounding."""


def standing(
    legs: Sequence[Leg], q_start: Array, period: float, findings: Sequence[Diagnostic]
) -> MotionPlan:
    """Return the plan of moves that all end where they begin.

    Args:
        legs: the moves.
        q_start: command joint coordinates [rad | m], shape (n,).
        period: time of a control tick [s].
        findings: on the moves.
    """
    moves = tuple(PlannedMove(leg.move, leg.planned.X_MT, leg.q_end, 0, 0.0) for leg in legs)
    nothing = JointReference(*(np.empty((0, len(q_start))) for _ in range(3)))
    return MotionPlan(moves, (), q_start, nothing, period, tuple(findings))


def in_ticks(
    chain: MotionChain,
    legs: Sequence[Leg],
    zones: Sequence[float],
    course: Course,
    kept: Kept,
    findings: Sequence[Diagnostic],
) -> MotionPlan:
    """Return the plan of a motion; it lasts a whole number of interpolation ticks.

    Args:
        chain: the entities; gives the rates.
        legs: the moves.
        zones: that are flown at their ends [m].
        course: of the stretch.
        kept: its motion within the limits of the joints.
        findings: on the moves.
    """
    rates = chain.controller.rates
    period, every = rates.control_period, rates.interpolation_ticks
    rows = len(kept.rows.q) - 1
    ticks = every * -(-rows // every)
    reference = _to_rest(kept.rows, legs[-1].q_end, ticks)
    phi = np.full(ticks, course.duration)
    phi[:rows] = kept.phi[1:]
    pieces = _pieces(course, phi, period)
    lasts = [0, *_ticks_of(course.ends[:-1], phi, period), ticks]
    moves, found = [], list(findings)
    for leg, zone, (first, last) in zip(legs, zones, pairwise(lasts), strict=True):
        X_MT, move = leg.planned.X_MT, leg.move
        triggers: tuple[PlannedTrigger, ...] = ()
        if move.triggers:
            along, q = leg.planned.coordination, reference.q[max(first - 1, 0) : last]
            q = np.concatenate((kept.rows.q[:1], q)) if first == 0 else q
            flown = Flown(chain.robot, X_MT, q, along.frame if along else None)
            triggers, told = trigger_ticks(move, flown, first, period)
            found += told
        of_tool, limits = leg.tool is not None, leg.planned.limits
        moves.append(PlannedMove(move, X_MT, leg.q_end, last, zone, triggers, limits, of_tool))
    blends = blend_ticks(course, pieces, phi, _SLACK * period)
    return MotionPlan(tuple(moves), pieces, kept.rows.q[0], reference, period, tuple(found), blends)


def _pieces(course: Course, phi: Array, period: float) -> tuple[PlannedPiece, ...]:
    """Return the pieces with a path of the tool, as far as no other run overlaps them."""
    times: list[float] = []
    for run, behind in zip(course.runs, [*course.runs[1:], None], strict=True):
        first, last = run.start + run.overlap, run.end - (behind.overlap if behind else 0.0)
        ends = run.law.ends[:-1].tolist()
        times += [min(max(run.start + time, first), last) for time in (0.0, *ends)]
        times.append(last)
    places: list[int] = np.searchsorted(phi, np.array(times) + _SLACK * period, side="right").tolist()
    places[-1] = len(phi)
    found, number = [], 0
    for run in course.runs:
        for piece in run.pieces:
            frame = piece.coordination.frame if piece.coordination else None
            first_tick, last_tick = places[number], places[number + 1]
            found.append(PlannedPiece(piece.tool, piece.X_MT, first_tick, last_tick, frame))
            number += 1
        number += 1
    return tuple(found)


def _ticks_of(times: Sequence[float], phi: Array, period: float) -> list[int]:
    """Return the first control ticks, 0 for the start, at which the motion has come to motion times.

    Args:
        times: motion times [s].
        phi: motion times at the control ticks 1, 2, … [s], shape (ticks,).
        period: time of a control tick [s].
    """
    if not times:
        return []
    wanted = np.array(times) - _SLACK * period
    found: list[int] = np.minimum(np.searchsorted(phi, wanted) + (wanted > 0.0), len(phi)).tolist()
    return found


def _to_rest(rows: JointPoints, q_end: Array, ticks: int) -> JointReference:
    """Return the reference of a motion, standing at its end until a control tick.

    The end is exact, without the rounding of sums.

    Args:
        rows: of the motion at the control ticks 0, 1, … to its end.
        q_end: joint coordinates there [rad | m], shape (n,).
        ticks: control ticks of the reference.
    """
    last = len(rows.q) - 2
    q, qd, qdd = np.empty((3, ticks, len(q_end)))
    q[:last], qd[:last], qdd[:last] = rows.q[1:-1], rows.d1[1:-1], rows.d2[1:-1]
    q[last:], qd[last:], qdd[last:] = q_end, 0.0, 0.0
    return JointReference(q, qd, qdd)
