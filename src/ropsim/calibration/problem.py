"""The fitting problem: settings from motion sequences, with any look-ahead."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.calibration.common_limits import common_limits
from ropsim.calibration.demands import demand
from ropsim.calibration.knowledge import felt
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.look_ahead import (
    FoundLookAhead,
    best_look_ahead,
    choices,
    depends,
    with_look_ahead,
)
from ropsim.calibration.refining import fits_under, refined, total_error
from ropsim.calibration.replanning import Replan
from ropsim.calibration.sequence_fit import SequenceFit, fit_sequence
from ropsim.core import frozen_dataclass
from ropsim.flow import MotionKind
from ropsim.model import LookAhead
from ropsim.planning import MotionSequence

_MOST_FITTED = 12
"""Stretches of which limits are fitted at most; the times of all are compared."""
_MOST_FOR_LOOK_AHEAD = 6
_ANOTHER_WAY = 0.05
"""Error of the best fit from which on a sequence went another way, as a share of the way of its joints."""
_CLOSE = 0.002
"""The same up to which limits can be read off a fit."""
_ROUNDS = 3


@frozen_dataclass
class Problem:
    """The fitting problem.

    Attributes:
        replan: plans the sequences.
        orders: all sequences of the program.
        known: limits of the project.
        logged: sequences that the trace has.
    """

    replan: Replan
    orders: tuple[MotionSequence, ...]
    known: MotionSettings
    logged: tuple[LoggedSequence, ...]

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

    def limits(self, logged: Sequence[LoggedSequence], settings: MotionSettings) -> MotionSettings:
        """Return limits that fit some sequences together."""
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

    def fits(self, logged: Sequence[LoggedSequence], settings: MotionSettings) -> list[SequenceFit]:
        """Return the fit of each motion sequence alone, without sequences on another path."""
        found = (fit_sequence(self.replan, one, settings, self._groups(one)) for one in logged)
        return [fit for fit in found if fit and goes_there(fit)]

    def chosen(self, logged: Sequence[LoggedSequence]) -> list[LoggedSequence]:
        """Return sequences of which limits are fitted: of each line of the program as many as of others."""
        turns: dict[tuple[object, ...], int] = {}
        ranked = []
        for one in logged:
            key = tuple(move.origin.span for move in self.orders[one.number].moves)
            turns[key] = turns.get(key, -1) + 1
            ranked.append((turns[key], one.number, one))
        ranked.sort(key=lambda entry: entry[:2])
        return sorted((one for _, _, one in ranked[:_MOST_FITTED]), key=lambda one: one.number)

    def _tell_all(self, free: Sequence[LoggedSequence], bound: Sequence[LoggedSequence]) -> bool:
        """Return whether sequences without look-ahead contain all kinds of paths of the sequences with it."""
        groups = [{group for one in some for group in self._groups(one)} for some in (free, bound)]
        return groups[0] >= groups[1]

    def _tried(
        self, bound: Sequence[LoggedSequence], free: Sequence[LoggedSequence], among: Sequence[LookAhead]
    ) -> MotionSettings:
        """Return the limits that fit best with any look-ahead, on a few sequences."""
        few = [*bound[:: max(1, len(bound) // _MOST_FOR_LOOK_AHEAD)], *free[:_MOST_FOR_LOOK_AHEAD]]
        found = [self.limits(few, with_look_ahead(self.known, value)) for value in among]
        errors = [total_error(fits_under(self.replan, few, one)) for one in found]
        return found[int(np.argmin(errors))]

    def _groups(self, logged: LoggedSequence) -> tuple[int, ...]:
        """Return the groups of limits that a sequence may determine: 0 of the joints, 1 of the tool."""
        kinds = {move.kind == MotionKind.PTP for move in self.orders[logged.number].moves}
        return (0,) if kinds == {True} else (0, 1)


def _unfelt_restored(
    known: MotionSettings, found: MotionSettings, fitted: npt.NDArray[np.intp]
) -> MotionSettings:
    """Return the limits that were found; limits that no sequence reaches are not below their known values."""
    kept = np.isin(np.arange(len(found.all)), fitted)
    return found.with_all(np.where(kept, found.all, np.maximum(found.all, known.all)))


def is_close(fit: SequenceFit) -> bool:
    """Return whether a sequence was fitted so well that its limits can be read off it."""
    way = float(np.ptp(fit.logged.q, axis=0).max())
    return fit.error <= _CLOSE * way + float(fit.logged.noise.max())


def goes_there(fit: SequenceFit) -> bool:
    """Return whether a fitted sequence went the way that is planned."""
    way = float(np.ptp(fit.logged.q, axis=0).max())
    return fit.error <= _ANOTHER_WAY * way + 3.0 * float(fit.logged.noise.max())
