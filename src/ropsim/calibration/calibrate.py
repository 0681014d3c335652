"""Calibration: the limits and the look-ahead of a controller from a trace of its robot."""

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ropsim.calibration.calibration import Calibration, SequenceTimes, TraceTime
from ropsim.calibration.comparing import Reason, compared, held, not_compared, reasons
from ropsim.calibration.demands import largest
from ropsim.calibration.diagnostics import MISFIT, OTHER_TRACE, CalibrationError
from ropsim.calibration.knowledge import felt, knowledge
from ropsim.calibration.limits import MotionSettings, settings_of
from ropsim.calibration.logged_sequence import LoggedSequence, duration
from ropsim.calibration.problem import Problem
from ropsim.calibration.refining import fits_under, spreads
from ropsim.calibration.replanning import replanner
from ropsim.calibration.sequence_fit import placed
from ropsim.calibration.trace.trace import Trace
from ropsim.core import Diagnostic
from ropsim.model import Cell, Station
from ropsim.planning import MotionSequence

_WORTH_SAYING = 0.02


def calibrate(
    cell: Cell,
    station: Station,
    orders: Sequence[MotionSequence],
    trace: Trace,
    planning: Callable[[], None] = lambda: None,
) -> tuple[Calibration | None, tuple[Diagnostic, ...]]:
    """Return the limits under which a program lasts as long as in a trace, and the findings.

    The trace is cut at its stops and matched with the motion sequences of the program; standstill between
    them does not count. Each sequence is fitted alone, common limits follow from the required limits of all,
    and these are refined on all sequences at once.

    Args:
        cell: static model.
        station: that made the moves.
        orders: its sequences, as a run planned them.
        trace: of its axes.
        planning: called before each sequence that is planned again.

    Returns:
        The calibration, None if the trace does not belong to this program; and the findings.
    """
    known = settings_of(station)
    replan = replanner(cell, station, orders, planning)
    try:
        logged, made, findings = compared(replan, orders, known, station.robot.axis_joints, trace)
    except CalibrationError as error:
        return None, (error.diagnostic,)
    along = [one.logged for one in fits_under(replan, logged, known) if one and one.goes_there]
    if not along:
        return None, (*findings, _nothing_compared(made))
    problem = Problem(replan, station.robot, tuple(orders), known, tuple(along))
    found, look = problem.solve()
    used = problem.chosen(along)
    numbers = [one.number for one in used]
    fitted = felt(replan, used, found)
    motions = [motion for one in logged if (motion := replan(one.number, found))]
    asked = np.max([largest(motion, found) for motion in motions], axis=0)
    times, strayed = _times(problem, logged, known, found)
    if not times:
        return None, (*findings, _nothing_compared(made))
    holds = held(replan, orders, known, station.robot.axis_joints, trace)
    why = {**reasons(holds, orders, {one.number for one in logged}), **strayed}
    lasted = {number: holds.lasted(number, trace) for number in why}
    left_out = _left_out(problem, logged, known, found, why, lasted)
    findings += (*_misfits(times), *not_compared(strayed, orders, made))
    spread = spreads(replan, used, found, fitted)
    evidence = knowledge(replan, numbers, found, asked, fitted, spread)
    axes = tuple(one.name for one in station.robot.axis_joints)
    compared_time = sum(one.logged for one in times)
    trace_time = TraceTime(
        float(trace.time[-1] - trace.time[0]),
        compared_time,
        holds.time_beside({*range(len(orders))} - set(why), trace),
    )
    made_of = Calibration(
        station.name,
        axes,
        known,
        found,
        evidence,
        look.kind,
        times,
        made,
        findings,
        left_out,
        trace_time,
    )
    return made_of, findings


def _nothing_compared(made: int) -> Diagnostic:
    message = f"none of the {made} motions of the program goes in the trace as it is planned"
    return OTHER_TRACE.at(None, message, hint="log the whole program, with all its stops")


def _times(
    problem: Problem, sequences: Sequence[LoggedSequence], before: MotionSettings, after: MotionSettings
) -> tuple[tuple[SequenceTimes, ...], dict[int, Reason]]:
    """Return the times of sequences that the trace has, and why some of them cannot be compared."""
    found, strayed = [], dict[int, Reason]()
    for logged in sequences:
        old, new = (problem.replan(logged.number, one) for one in (before, after))
        if old is None or new is None:
            strayed[logged.number] = Reason.UNPLANNED
            continue
        fit = placed(logged, after, new)
        lasted = duration(logged, new, fit.start)
        if not fit.goes_there or not lasted > 0.0:
            strayed[logged.number] = Reason.OTHER_WAY
            continue
        first, last = (problem.orders[logged.number].moves[end].origin for end in (0, -1))
        found.append(
            SequenceTimes(first.span, last.span, last.visit, lasted, old.duration, new.duration, fit.error)
        )
    return tuple(found), strayed


def _left_out(
    problem: Problem,
    sequences: Sequence[LoggedSequence],
    before: MotionSettings,
    after: MotionSettings,
    why: Mapping[int, Reason],
    lasted: Mapping[int, float],
) -> tuple[SequenceTimes, ...]:
    """Return the motion sequences that are not compared, in order, with their known times."""
    logged, found = {one.number: one for one in sequences}, []
    for number, reason in sorted(why.items()):
        first, last = (problem.orders[number].moves[end].origin for end in (0, -1))
        old, new = (problem.replan(number, one) for one in (before, after))
        error = placed(logged[number], after, new).error if new and number in logged else math.nan
        planned, fitted = (one.duration if one else math.nan for one in (old, new))
        times = lasted[number], planned, fitted
        found.append(SequenceTimes(first.span, last.span, last.visit, *times, error, reason.value))
    return tuple(found)


def _misfits(times: Sequence[SequenceTimes]) -> tuple[Diagnostic, ...]:
    """Return X899 for each line with a sequence that still lasts longer or shorter, at its worst visit."""
    worst: dict[object, SequenceTimes] = {}
    for one in times:
        if abs(one.remaining) > _WORTH_SAYING:
            kept = worst.setdefault(one.last, one)
            worst[one.last] = one if abs(one.remaining) > abs(kept.remaining) else kept
    return tuple(
        MISFIT.at(
            one.last,
            f"the motion to here lasts {one.logged:.3f} s in the trace and {one.after:.3f} s "
            f"with the best limits, {one.remaining:+.1%}",
            label=f"pass {one.visit}",
            hint="look whether the program gives a speed here that the robot does not keep",
            data={"logged_s": one.logged, "planned_s": one.after, "pass": one.visit},
        )
        for one in worst.values()
    )
