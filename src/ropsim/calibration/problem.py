"""The fitting problem: settings from motion sequences, with any look-ahead."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.calibration.easing import eased
from ropsim.calibration.least_limits import least_limits
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence, duration
from ropsim.calibration.look_ahead import (
    FoundLookAhead,
    best_look_ahead,
    choices,
    coarse,
    depends,
    likely_look_aheads,
    with_look_ahead,
)
from ropsim.calibration.refining import Trial, fits_under, refined
from ropsim.calibration.replanning import Replan
from ropsim.calibration.sequence_fit import SequenceFit
from ropsim.core import frozen_dataclass
from ropsim.flow import MotionKind
from ropsim.model import LookAhead, RobotModel
from ropsim.planning import MotionSequence

_MOST_FITTED = 12
"""Sequences of which limits are fitted at first; the times of all are compared."""
_MOST_EASED = 40
"""Sequences that must stay unchanged when limits go back to known ones."""
_MORE, _GATHERINGS = 4, 2
"""Sequences that fit worst and are then added, and how often."""
_WORTH_ADDING = 5e-4
"""Share of its way from which on a sequence that was not fitted is added."""
_MOST_FOR_LOOK_AHEAD = 6
_ROUNDS = 3
_FEW_STEPS, _SOME_STEPS = 4, 8
_FEWEST = 3
"""Sequences on which look-aheads are tried together with limits."""
_MISFIT = 1.5e-3
"""Share of the way without noise, root of the mean square, from which on other beginnings are tried.

Planning is not smooth: a limit that changes by some thousandths may change a motion that joints slow down
by a thousandth of its way."""
_LATE = 1e-2
"""Share of its time by which a sequence is wrong, root of the mean square, from which on they are tried:
ends of motions are a small way and a long time."""
_RISE = 1.4
"""Factor of all limits in one of them."""
_OTHER_RAMPS = np.array([1.0, 0.5, 2.0])
"""Factors of speed, acceleration and jerk of the tool in another one."""


@frozen_dataclass
class Problem:
    """The fitting problem.

    Attributes:
        replan: plans the sequences.
        robot: the arm.
        orders: all sequences of the program.
        known: limits of the project.
        logged: sequences that the trace has and that go along their planned paths.
    """

    replan: Replan
    robot: RobotModel
    orders: tuple[MotionSequence, ...]
    known: MotionSettings
    logged: tuple[LoggedSequence, ...]

    def solve(self) -> tuple[MotionSettings, FoundLookAhead]:
        """Return the limits and the look-ahead that fit best."""
        known = self.known.look_ahead
        among = choices(self.orders, [one.number for one in self.logged], known)
        bound = [one for one in self.logged if depends(self.replan, one.number, self.known, among[-1])]
        free = [one for one in self.logged if one not in bound]
        settings = self.known
        if bound and self._tell_all(free, bound):
            settings = self.limits(free, settings)
        elif bound:
            few = [*bound[:: max(1, len(bound) // _FEWEST)][:_FEWEST], *free[:_FEWEST]]
            settings = self._tried(few, coarse(among, known), settings, np.arange(len(settings.all)), few)
        tried = bound[:: max(1, len(bound) // _MOST_FOR_LOOK_AHEAD)]
        likely = likely_look_aheads(self.replan, tried, settings, among)
        if len(likely) > 1:
            of_tool = np.arange(settings.joints.size, len(settings.all))
            judged = [*tried, *self.chosen(free)]
            settings = self._tried(tried[:_FEWEST], likely, settings, of_tool, judged)
        look = best_look_ahead(self.replan, tried, settings, among, known)
        for number in range(_ROUNDS):
            begin = with_look_ahead(settings, look.value)
            settings = (
                self.limits(self.logged, begin) if number == 0 else self.limits_near(self.logged, begin)
            )
            again = best_look_ahead(self.replan, tried, settings, among, known)
            if again.value == look.value:
                look = again
                break
            look = again
        return with_look_ahead(settings, look.value), look

    def limits(self, logged: Sequence[LoggedSequence], settings: MotionSettings) -> MotionSettings:
        """Return limits that fit some sequences together, beginning with the given ones.

        The worst fits are added to the chosen sequences, so that no sequence with information is left out.
        """
        used = self.chosen(logged)
        return self._gathered(logged, used, self._started(used, settings))

    def limits_near(self, logged: Sequence[LoggedSequence], settings: MotionSettings) -> MotionSettings:
        """Return limits that fit some sequences together; the given ones result from a fit."""
        used = self.chosen(logged)
        begin = refined(self.replan, used, settings, np.arange(len(settings.all)))
        return self._gathered(logged, used, begin)

    def _gathered(
        self, logged: Sequence[LoggedSequence], used: list[LoggedSequence], best: Trial
    ) -> MotionSettings:
        """Return a fit to chosen sequences and the worst others; known limits stay where they fit."""
        every = np.arange(len(best.settings.all))
        known = with_look_ahead(self.known, best.settings.look_ahead)
        for _ in range(_GATHERINGS):
            more = self._worst([one for one in logged if one not in used], best)
            if not more:
                break
            used = [*used, *more]
            best = refined(self.replan, used, best.settings, every)
        witnesses = [*used, *(one for one in self.chosen(logged, _MOST_EASED) if one not in used)]
        whole = Trial(best.settings, fits_under(self.replan, witnesses, best.settings))
        found, kept = eased(self.replan, known, whole)
        return refined(self.replan, used, found.settings, kept, _FEW_STEPS).settings

    def _started(self, used: Sequence[LoggedSequence], settings: MotionSettings) -> Trial:
        """Return the best fit of several beginnings, the most promising one first, until one fits well.

        They are the given limits, joint limits that PTP moves tell, and the best fit so far with all limits
        higher: where two limits hold a motion back alike and one of them should be higher, neither has an
        effect alone upward, and with all of them higher those come down that hold it back. At last the tool
        has less acceleration and more jerk: short lines last as long with the one or the other.
        """
        begins = [Trial(one, fits_under(self.replan, used, one)) for one in self._begins(used, settings)]
        every, best = np.arange(len(settings.all)), None
        for begin in sorted(begins, key=lambda trial: trial.error):
            found = refined(self.replan, used, begin.settings, every)
            best = found if best is None or found.error < best.error else best
            if _is_met(best):
                return best
        assert best is not None
        higher = best.settings.with_all(_RISE * best.settings.all)
        for one in (higher, best.settings.scaled(np.ones(3), _OTHER_RAMPS)):
            best = min((best, refined(self.replan, used, one, every)), key=lambda trial: trial.error)
            if _is_met(best):
                break
        return best

    def _begins(self, used: Sequence[LoggedSequence], settings: MotionSettings) -> list[MotionSettings]:
        """Return given limits, and limits from simple sequences, as few as these need.

        They are sequences of PTP moves, and these with sequences of a single move on a path of the tool.
        """
        of_joints = [one for one in used if self._groups(one) == (0,)]
        simple = [one for one in used if one in of_joints or len(self.orders[one.number].moves) == 1]
        found = [settings]
        for some in (of_joints, simple) if len(simple) > len(of_joints) else (of_joints,):
            if some:
                least = least_limits(self.replan, self.robot, some, settings)
                told, _ = eased(self.replan, settings, Trial(least, fits_under(self.replan, some, least)))
                found.append(told.settings)
        return found

    def _worst(self, others: Sequence[LoggedSequence], best: Trial) -> list[LoggedSequence]:
        """Return the sequences that fit worst, where that is worse than those do that were fitted."""
        usual = max(2.0 * best.left, _WORTH_ADDING)
        fits = fits_under(self.replan, others, best.settings)
        wrong = sorted((fit for fit in fits if fit and fit.left > usual), key=lambda fit: -fit.left)
        return [fit.logged for fit in wrong[:_MORE]]

    def chosen(self, logged: Sequence[LoggedSequence], most: int = _MOST_FITTED) -> list[LoggedSequence]:
        """Return sequences of which limits are fitted: of each line of the program as many as of others."""
        turns: dict[tuple[object, ...], int] = {}
        ranked = []
        for one in logged:
            key = tuple(move.origin.span for move in self.orders[one.number].moves)
            turns[key] = turns.get(key, -1) + 1
            ranked.append((turns[key], one.number, one))
        ranked.sort(key=lambda entry: entry[:2])
        return sorted((one for _, _, one in ranked[:most]), key=lambda one: one.number)

    def _tell_all(self, free: Sequence[LoggedSequence], bound: Sequence[LoggedSequence]) -> bool:
        """Return whether sequences without look-ahead contain all kinds of paths of the sequences with it."""
        groups = [{group for one in some for group in self._groups(one)} for some in (free, bound)]
        return groups[0] >= groups[1]

    def _tried(
        self,
        few: Sequence[LoggedSequence],
        among: Sequence[LookAhead],
        begin: MotionSettings,
        free: npt.NDArray[np.intp],
        judged: Sequence[LoggedSequence],
    ) -> MotionSettings:
        """Return settings of fits to a few sequences with each of some look-aheads: those that fit best.

        Another look-ahead may be made up for by limits that others of the judged sequences speak against.
        """
        found = []
        for value in among:
            fit = refined(self.replan, few, with_look_ahead(begin, value), free, _SOME_STEPS)
            found.append(Trial(fit.settings, fits_under(self.replan, judged, fit.settings)))
        return min(found, key=lambda trial: trial.error).settings

    def _groups(self, logged: LoggedSequence) -> tuple[int, ...]:
        """Return the groups of limits that a sequence may determine: 0 of the joints, 1 of the tool."""
        kinds = {move.kind == MotionKind.PTP for move in self.orders[logged.number].moves}
        return (0,) if kinds == {True} else (0, 1)


def _is_met(trial: Trial) -> bool:
    """Return whether the motions of a trial go and last as in the trace."""
    fits = [fit for fit in trial.fits if fit]
    late = [fit.motion.duration / lasted - 1.0 for fit in fits if (lasted := _lasted(fit)) > 0.0]
    return trial.left <= _MISFIT and float(np.mean(np.square(late or [0.0]))) <= _LATE**2


def _lasted(fit: SequenceFit) -> float:
    """Return how long a sequence lasted in the trace [s]."""
    return duration(fit.logged, fit.motion, fit.start)
