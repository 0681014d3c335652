"""Calibration: the limits and the look-ahead of a controller from a trace of its robot."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ropsim.calibration.calibration import Calibration, StretchTimes
from ropsim.calibration.common_limits import common_limits
from ropsim.calibration.comparing import compared
from ropsim.calibration.demands import demand, largest
from ropsim.calibration.diagnostics import MISFIT, OTHER_TRACE, CalibrationError
from ropsim.calibration.knowledge import felt, knowledge
from ropsim.calibration.limits import MotionSettings, settings_of
from ropsim.calibration.logged_stretch import LoggedStretch, duration
from ropsim.calibration.look_ahead import (
    FoundLookAhead,
    best_look_ahead,
    choices,
    depends,
    with_look_ahead,
)
from ropsim.calibration.refining import fits_under, refined, total_error
from ropsim.calibration.replanning import Replan, replanner
from ropsim.calibration.stretch_fit import StretchFit, fit_stretch, placed
from ropsim.calibration.trace import Trace
from ropsim.controller import StretchOrder
from ropsim.core import Diagnostic
from ropsim.flow import MotionKind
from ropsim.model import Cell, Station

_MOST_FITTED = 12
"""Stretches of which limits are fitted at most; the times of all are compared."""
_MOST_FOR_LOOK_AHEAD = 6
_WORTH_SAYING = 0.02
_ANOTHER_WAY = 0.05
"""Error of the best fit from which on a stretch went another way, as a share of the way of its joints."""
_CLOSE = 0.002
"""The same up to which limits can be read off a fit."""
_ROUNDS = 3


def calibrate(
    cell: Cell, station: Station, orders: Sequence[StretchOrder], trace: Trace
) -> tuple[Calibration | None, tuple[Diagnostic, ...]]:
    """Return the limits under which a program lasts as long as in a trace, and what was found on the way.

    The trace is cut at its stops and matched with the stretches of the program; how long the robot stands
    between them does not count. Each stretch is fitted alone, limits for all of them are taken from what it
    asks, and these are refined on all stretches at once.

    Args:
        cell: static model.
        station: that made the moves.
        orders: its stretches, as a run planned them.
        trace: of its axes.

    Returns:
        The calibration, None where the trace is not one of this program; and the findings.
    """
    known = settings_of(station)
    replan = replanner(cell, station, orders)
    try:
        logged, made, findings = compared(replan, orders, known, station.robot.axis_joints, trace)
    except CalibrationError as error:
        return None, (error.diagnostic,)
    problem = Problem(replan, tuple(orders), known, tuple(logged))
    fits = problem.fits(problem.chosen(logged), known)
    if not fits:
        return None, (*findings, _nothing_compared(made))
    found, look = problem.solve()
    numbers = [one.number for one in problem.chosen(logged)]
    fitted = felt(replan, problem.chosen(logged), found)
    motions = [motion for one in logged if (motion := replan(one.number, found))]
    asked = np.max([largest(motion, found) for motion in motions], axis=0)
    times = _times(problem, known, found)
    if not times:
        return None, (*findings, _nothing_compared(made))
    findings += _misfits(times)
    told = knowledge(replan, numbers, found, asked, fitted)
    axes = tuple(one.name for one in station.robot.axis_joints)
    made_of = Calibration(station.name, axes, known, found, told, look.kind, times, made, findings)
    return made_of, findings


def _nothing_compared(made: int) -> Diagnostic:
    message = f"none of the {made} motions of the program goes in the trace as it is planned"
    return OTHER_TRACE.at(None, message, hint="log the whole program, with all its stops")


@dataclass(frozen=True, slots=True)
class Problem:
    """What is to be fitted.

    Attributes:
        replan: plans the stretches.
        orders: all stretches of the program.
        known: limits of the project.
        logged: stretches that the trace has.
    """

    replan: Replan
    orders: tuple[StretchOrder, ...]
    known: MotionSettings
    logged: tuple[LoggedStretch, ...]

    def solve(self) -> tuple[MotionSettings, FoundLookAhead]:
        """Return the limits and the look-ahead that fit best."""
        among = choices(self.orders, [one.number for one in self.logged])
        bound = [one for one in self.logged if depends(self.replan, one.number, self.known, among[-1])]
        free = [one for one in self.logged if one not in bound]
        settings = self.known
        if bound and self._tell_all(free, bound):
            settings = self.limits(free, settings)
        elif bound:
            settings = self._tried(bound, free, among)
        tried = bound[:: max(1, len(bound) // _MOST_FOR_LOOK_AHEAD)]
        look = best_look_ahead(self.replan, tried, settings, among, self.known.look_ahead)
        for _ in range(_ROUNDS):
            settings = self.limits(self.logged, with_look_ahead(settings, look.value))
            again = best_look_ahead(self.replan, tried, settings, among, self.known.look_ahead)
            if again.value == look.value:
                look = again
                break
            look = again
        return with_look_ahead(settings, look.value), look

    def limits(self, logged: Sequence[LoggedStretch], settings: MotionSettings) -> MotionSettings:
        """Return limits that fit some stretches together."""
        chosen = self.chosen(logged)
        fits = self.fits(chosen, settings)
        fits = [fit for fit in fits if is_close(fit)] or fits
        if not fits:
            return settings
        demands = [demand(self.replan, fit) for fit in fits]
        known = with_look_ahead(self.known, settings.look_ahead)
        found = common_limits(self.replan, known, fits, demands)
        used = [fit.logged for fit in fits]
        better = refined(self.replan, used, found, felt(self.replan, used, found))
        return _unfelt_restored(known, better, felt(self.replan, used, better))

    def fits(self, logged: Sequence[LoggedStretch], settings: MotionSettings) -> list[StretchFit]:
        """Return the fit of each stretch alone, without those that went another way."""
        found = (fit_stretch(self.replan, one, settings, self._groups(one)) for one in logged)
        return [fit for fit in found if fit and goes_there(fit)]

    def chosen(self, logged: Sequence[LoggedStretch]) -> list[LoggedStretch]:
        """Return stretches of which limits are fitted: of each line of the program as many as of others."""
        turns: dict[tuple[object, ...], int] = {}
        ranked = []
        for one in logged:
            key = tuple(move.origin.span for move in self.orders[one.number].moves)
            turns[key] = turns.get(key, -1) + 1
            ranked.append((turns[key], one.number, one))
        ranked.sort(key=lambda entry: entry[:2])
        return sorted((one for _, _, one in ranked[:_MOST_FITTED]), key=lambda one: one.number)

    def _tell_all(self, free: Sequence[LoggedStretch], bound: Sequence[LoggedStretch]) -> bool:
        """Return whether stretches without look-ahead have all the kinds of paths that those with it have."""
        groups = [{group for one in some for group in self._groups(one)} for some in (free, bound)]
        return groups[0] >= groups[1]

    def _tried(
        self, bound: Sequence[LoggedStretch], free: Sequence[LoggedStretch], among: Sequence[int]
    ) -> MotionSettings:
        """Return the limits that fit best with any look-ahead, on a few stretches."""
        few = [*bound[:: max(1, len(bound) // _MOST_FOR_LOOK_AHEAD)], *free[:_MOST_FOR_LOOK_AHEAD]]
        found = [self.limits(few, with_look_ahead(self.known, value)) for value in among]
        errors = [total_error(fits_under(self.replan, few, one)) for one in found]
        return found[int(np.argmin(errors))]

    def _groups(self, logged: LoggedStretch) -> tuple[int, ...]:
        """Return which limits a stretch may tell: 0 those of the joints, 1 those of the tool."""
        kinds = {move.kind == MotionKind.PTP for move in self.orders[logged.number].moves}
        return (0,) if kinds == {True} else (0, 1)


def _unfelt_restored(
    known: MotionSettings, found: MotionSettings, fitted: npt.NDArray[np.intp]
) -> MotionSettings:
    """Return the limits that were found; those that no stretch is at are not lower than they were known."""
    kept = np.isin(np.arange(len(found.all)), fitted)
    return found.with_all(np.where(kept, found.all, np.maximum(found.all, known.all)))


def is_close(fit: StretchFit) -> bool:
    """Return whether a stretch was fitted so well that its limits can be read off it."""
    way = float(np.ptp(fit.logged.q, axis=0).max())
    return fit.error <= _CLOSE * way + float(fit.logged.noise.max())


def goes_there(fit: StretchFit) -> bool:
    """Return whether a fitted stretch went the way that is planned."""
    way = float(np.ptp(fit.logged.q, axis=0).max())
    return fit.error <= _ANOTHER_WAY * way + 3.0 * float(fit.logged.noise.max())


def _times(problem: Problem, before: MotionSettings, after: MotionSettings) -> tuple[StretchTimes, ...]:
    found = []
    for logged in problem.logged:
        old, new = (problem.replan(logged.number, one) for one in (before, after))
        if old is None or new is None:
            continue
        moves = problem.orders[logged.number].moves
        fit = placed(logged, after, new)
        if not goes_there(fit):
            continue
        lasted = duration(logged, new, fit.start)
        if not lasted > 0.0:
            continue
        first, last = moves[0].origin, moves[-1].origin
        found.append(
            StretchTimes(first.span, last.span, last.visit, lasted, old.duration, new.duration, fit.error)
        )
    return tuple(found)


def _misfits(times: Sequence[StretchTimes]) -> tuple[Diagnostic, ...]:
    """Return X899 for each line with a stretch that still lasts longer or shorter, at its worst visit."""
    worst: dict[object, StretchTimes] = {}
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
