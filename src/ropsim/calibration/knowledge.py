"""Evidence of a trace for each limit: its value, a lower bound, or nothing."""

from collections.abc import Sequence
from enum import Enum

import numpy as np
import numpy.typing as npt

from ropsim.calibration.demands import RAISED, is_felt
from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import Replan
from ropsim.calibration.slopes import may_be_at
from ropsim.spatial import Array, frozen, record

_TICKS = 1.5
"""Control ticks by which a motion must change for that."""
_SURE = 0.015
"""Share of a limit up to which its value may be uncertain, one standard deviation, to count as fitted."""
_DEVIATIONS = 3.0
"""Standard deviations below an uncertain value at which it is taken to be no less."""
_HALVINGS = 7
_LOWEST = 1.0 / 64.0
_STANDS = 1e-3
"""Share of its limit up to which an axis counts as standing."""


class Knowledge(Enum):
    """How a limit is known from a trace.

    An uncertain one acts on a motion, but so do others, or the motion is not met: it may have another value.
    """

    FITTED = "fitted"
    UNCERTAIN = "uncertain"
    AT_LEAST = "at least"
    NOT_SEEN = "not seen"


@record
class LimitKnowledge:
    """Evidence for all limits, in the order of `MotionSettings.all`.

    Attributes:
        kinds: how each is known.
        values: value or lower bound; 0 if not seen, shape (3n + 6,).
        spreads: standard deviations of the logarithms of fitted and uncertain ones, so about shares of them;
            infinite where others would do as well whatever its value is, and for all others, shape (3n + 6,).
    """

    kinds: tuple[Knowledge, ...]
    values: Array
    spreads: Array

    def __post_init__(self) -> None:
        for name in ("values", "spreads"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


def felt(replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings) -> npt.NDArray[np.intp]:
    """Return the numbers of the limits that sequences are at: with a higher one they would go otherwise.

    Args:
        replan: plans the sequences.
        logged: the sequences.
        settings: limits in force.
    """
    found = []
    may = {one.number: _may_be_at(replan, one, settings) for one in logged}
    for limit in range(len(settings.all)):
        raised = settings.all
        raised[limit] *= RAISED
        higher = settings.with_all(raised)
        if any(_is_other(replan, one, settings, higher) for one in logged if may[one.number][limit]):
            found.append(limit)
    return np.array(found, dtype=np.intp)


def _may_be_at(replan: Replan, logged: LoggedSequence, settings: MotionSettings) -> npt.NDArray[np.bool_]:
    """Return which limits a sequence may reach, shape (3n + 6,): near ones, and all of the tool."""
    motion = replan(logged.number, settings)
    if motion is None:
        return np.zeros(len(settings.all), dtype=np.bool_)
    return may_be_at(motion, settings)


def _is_other(
    replan: Replan, logged: LoggedSequence, settings: MotionSettings, higher: MotionSettings
) -> bool:
    motion, other = replan(logged.number, settings), replan(logged.number, higher)
    return motion is not None and other is not None and is_felt(logged, motion, other)


def knowledge(
    replan: Replan,
    numbers: Sequence[int],
    settings: MotionSettings,
    asked: Array,
    fitted: npt.NDArray[np.intp],
    spread: Array,
) -> LimitKnowledge:
    """Return the evidence for each limit.

    Args:
        replan: plans the sequences.
        numbers: of the sequences.
        settings: limits that were fitted.
        asked: largest speeds, accelerations and jerks of the joints in the trace, shape (3, n).
        fitted: numbers of the limits that set the time of a sequence, shape (m,).
        spread: standard deviations of their logarithms, shape (m,).
    """
    spreads = dict(zip(fitted.tolist(), spread.tolist(), strict=True))
    limits = settings.all
    least = np.concatenate((np.minimum(asked, settings.joints).ravel(), np.zeros(settings.tool.size)))
    for limit in range(asked.size, len(limits)):
        if limit not in fitted:
            least[limit] = _least_without_effect(replan, numbers, settings, limit)
    kinds = []
    for limit, value in enumerate(limits.tolist()):
        if limit in spreads:
            sure = spreads[limit] <= _SURE
            kinds.append(Knowledge.FITTED if sure else Knowledge.UNCERTAIN)
            least[limit] = value if sure else value * np.exp(-_DEVIATIONS * spreads[limit])
        elif least[limit] > _STANDS * value:
            kinds.append(Knowledge.AT_LEAST)
        else:
            kinds.append(Knowledge.NOT_SEEN)
            least[limit] = 0.0
    every = np.full(len(limits), np.inf)
    every[fitted] = spread
    return LimitKnowledge(tuple(kinds), least, every)


def _least_without_effect(
    replan: Replan, numbers: Sequence[int], settings: MotionSettings, limit: int
) -> float:
    """Return the lowest value of a limit that changes no time; 0 where even a tiny one changes none."""
    known = {number: _ticks(replan, number, settings) for number in numbers}

    def matters(share: float) -> bool:
        lowered = settings.all
        lowered[limit] *= share
        lower = settings.with_all(lowered)
        return any(_ticks(replan, number, lower) >= known[number] + _TICKS for number in numbers)

    if not matters(_LOWEST):
        return 0.0
    low, high = np.log(_LOWEST), 0.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if matters(float(np.exp(middle))) else (low, middle)
    return float(settings.all[limit] * np.exp(high))


def _ticks(replan: Replan, number: int, settings: MotionSettings) -> float:
    motion = replan(number, settings)
    return float(motion.ticks) if motion else np.inf
