"""Look-ahead of the controller of a trace, in moves."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.calibration.knowledge import Knowledge
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.refining import fits_under, total_error
from ropsim.calibration.replanning import Replan
from ropsim.core import frozen_dataclass
from ropsim.model import LookAhead
from ropsim.planning import MotionSequence

MOST = 40
"""Largest look-ahead that is distinguished from a larger one."""

_NONE = LookAhead(0, 0.0)
_TICKS = 1.5
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


def choices(orders: Sequence[MotionSequence], numbers: Sequence[int]) -> tuple[LookAhead, ...]:
    """Return the look-aheads in moves that may differ: none beyond the longest sequence does."""
    longest = max((len(orders[number].moves) for number in numbers), default=1)
    return tuple(LookAhead(moves, 0.0) for moves in range(min(longest, MOST + 1)))


def depends(replan: Replan, number: int, settings: MotionSettings, most: LookAhead) -> bool:
    """Return whether a motion sequence lasts longer with a shorter look-ahead."""
    known = settings.look_ahead
    furthest = LookAhead(max(most.moves, known.moves), known.braking)
    least, all_of_it = (replan(number, with_look_ahead(settings, value)) for value in (_NONE, furthest))
    return bool(least and all_of_it and least.ticks >= all_of_it.ticks + _TICKS)


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
