"""Look-ahead of the controller of a trace, in moves."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.calibration.knowledge import Knowledge
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.refining import Trial, fits_under, total_error
from ropsim.calibration.replanning import Replan
from ropsim.core import frozen_dataclass
from ropsim.model import LookAhead
from ropsim.planning import MotionSequence

MOST = 40
"""Largest look-ahead that is distinguished from a larger one."""

_NONE = LookAhead(0, 0.0)
_TICKS = 1.5
_LIKELY = 9.0
"""Factor of the squared error within which a look-ahead may be the best one under other limits."""
_MOST_LIKELY = 4
_AS_GOOD = 1.02
"""Factor of the squared error within which a look-ahead is as good as the best one."""


@frozen_dataclass
class FoundLookAhead:
    """Result of the search for the look-ahead.

    Attributes:
        value: the look-ahead.
        kind: whether it is exact, a lower bound, or not determined by the trace.
    """

    value: LookAhead
    kind: Knowledge


def with_look_ahead(settings: MotionSettings, value: LookAhead) -> MotionSettings:
    """Return settings with another look-ahead."""
    return replace(settings, look_ahead=value)


def choices(
    orders: Sequence[MotionSequence], numbers: Sequence[int], known: LookAhead
) -> tuple[LookAhead, ...]:
    """Return the look-aheads in moves that may differ: none beyond the longest sequence does.

    The known one is among them where it counts a length of path.
    """
    longest = max((len(orders[number].moves) for number in numbers), default=1)
    found = [LookAhead(moves, 0.0) for moves in range(min(longest, MOST + 1))]
    if known.braking and known.moves < len(found):
        found.insert(known.moves + 1, known)
    return tuple(found)


def coarse(among: Sequence[LookAhead], known: LookAhead) -> tuple[LookAhead, ...]:
    """Return a few of the choices: each about twice as far as the one before, and the known one."""
    found, least = [], 0
    for one in among:
        if one == known or one.moves >= least:
            found.append(one)
            least = max(one.moves + 1, 2 * one.moves + 1) if one != known else least
    return tuple(found)


def depends(replan: Replan, number: int, settings: MotionSettings, most: LookAhead) -> bool:
    """Return whether a motion sequence lasts longer with a shorter look-ahead."""
    known = settings.look_ahead
    furthest = LookAhead(max(most.moves, known.moves), known.braking)
    least, all_of_it = (replan(number, with_look_ahead(settings, value)) for value in (_NONE, furthest))
    return bool(least and all_of_it and least.ticks >= all_of_it.ticks + _TICKS)


def likely_look_aheads(
    replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings, among: Sequence[LookAhead]
) -> tuple[LookAhead, ...]:
    """Return a few look-aheads that other limits might make the best one, in rising order of moves.

    None where a sequence goes well enough with one of them that its limits are not in doubt.

    Args:
        replan: plans the sequences.
        logged: sequences that depend on it.
        settings: limits in force.
        among: look-aheads in rising order of moves.
    """
    tried = [with_look_ahead(settings, value) for value in among]
    trials = [Trial(one, fits_under(replan, logged, one)) for one in tried]
    best = min(trials, key=lambda trial: trial.error)
    if best.is_good:
        return ()
    good = [trial.settings.look_ahead for trial in trials if trial.error <= _LIKELY * best.error]
    places = {round(place) for place in np.linspace(0, len(good) - 1, min(_MOST_LIKELY, len(good)))}
    return tuple(good[place] for place in sorted(places))


def best_look_ahead(
    replan: Replan,
    logged: Sequence[LoggedSequence],
    settings: MotionSettings,
    among: Sequence[LookAhead],
    known: LookAhead,
) -> FoundLookAhead:
    """Return the look-ahead under which sequences go most as in the trace.

    Args:
        replan: plans the sequences.
        logged: sequences that depend on it.
        settings: limits in force.
        among: look-aheads in rising order of moves.
        known: look-ahead that is kept where others are no better.
    """
    errors = {
        value: total_error(fits_under(replan, logged, with_look_ahead(settings, value))) for value in among
    }
    least = min(errors.values(), default=0.0)
    good = [value for value, error in errors.items() if error <= _AS_GOOD * least]
    if not logged or len(good) == len(errors):
        return FoundLookAhead(known, Knowledge.NOT_SEEN)
    if good[-1] != among[-1]:
        value = min(good, key=lambda one: (errors[one], one.moves))
        return FoundLookAhead(value, Knowledge.FITTED)
    kept = known if known.moves >= good[0].moves else good[0]
    return FoundLookAhead(kept, Knowledge.AT_LEAST)
