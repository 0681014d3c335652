"""Limits of all joints and of the tool, required by many motion sequences."""

from collections.abc import Iterator, Sequence

import numpy as np

from ropsim.calibration.demands import Demand
from ropsim.calibration.limits import ORDERS, MotionSettings
from ropsim.calibration.replanning import Replan
from ropsim.calibration.sequence_fit import SequenceFit
from ropsim.core import frozen_dataclass
from ropsim.spatial import Array

_AT_LIMIT = 0.95
"""Share of the largest demand of all sequences from which on a joint may be at its limit."""
_ROUNDING = 1.02
"""Factor by which a demand must be above the known limit for this to be raised."""
_LIKELY = 0.4
"""Lowest factor to its known limit that a joint may have, as a share of the highest one of all joints."""
_TOO_QUICK = 0.003
"""Share of its time by which a motion must be too short for a limit to be lowered."""


@frozen_dataclass
class _Guess:
    """A limit that may set the time of a sequence.

    Attributes:
        limit: its number, in the order of `all`.
        value: that it has then [SI].
        share: of the known limit.
    """

    limit: int
    value: float
    share: float


def common_limits(
    replan: Replan, known: MotionSettings, fits: Sequence[SequenceFit], demands: Sequence[Demand]
) -> MotionSettings:
    """Return one set of limits that allows all motion sequences as fitted.

    No limit is below the requirement of any sequence. If the time of a sequence is set by a speed,
    acceleration or jerk of the joints, one joint is at its limit. It is a joint with its greatest utilisation
    there; of several the one whose limit changes least from the known value: most robots differ from their
    model by a factor that is near for all axes. A limit is lowered only if a sequence is too quick without
    it, the smallest change first.

    Args:
        replan: plans the sequences.
        known: limits before.
        fits: of the sequences.
        demands: theirs.
    """
    least = np.max([one.joints for one in demands], axis=0)
    limits = known.all
    count = least.size
    limits[:count] = np.where(least > _ROUNDING * known.joints, least, known.joints).ravel()
    guesses = [
        [*_of_joints(one, least, known), *_of_tool(fit, one, known)]
        for fit, one in zip(fits, demands, strict=True)
    ]
    limits = _raised(limits, known, guesses)
    tried = _unlikely(guesses, known)
    while True:
        settings = known.with_all(limits)
        quick = [
            guess
            for fit, some in zip(fits, guesses, strict=True)
            if _is_too_quick(replan, fit, settings)
            for guess in some
            if guess.limit not in tried
        ]
        if not quick:
            return settings
        chosen = max(quick, key=lambda guess: (guess.share, -guess.limit)).limit
        tried.add(chosen)
        limits[chosen] = np.median([one.value for some in guesses for one in some if one.limit == chosen])


def _unlikely(guesses: Sequence[Sequence[_Guess]], known: MotionSettings) -> set[int]:
    """Return limits of joints that would have to be lowered far more than that of another joint."""
    n = known.joints.shape[1]
    shares: dict[int, float] = {}
    for one in (guess for some in guesses for guess in some):
        if one.limit < known.joints.size:
            shares[one.limit] = max(shares.get(one.limit, 0.0), one.share)
    highest = [
        max((share for limit, share in shares.items() if limit // n == order), default=0.0)
        for order in range(ORDERS)
    ]
    return {limit for limit, share in shares.items() if share < _LIKELY * highest[limit // n]}


def _of_joints(one: Demand, least: Array, known: MotionSettings) -> Iterator[_Guess]:
    n = known.joints.shape[1]
    for order in range(ORDERS):
        if one.at_joints[order]:
            row = one.joints[order]
            share = np.where(row >= _AT_LIMIT * least[order], row / known.joints[order], 0.0)
            joint = int(share.argmax())
            yield _Guess(order * n + joint, float(row[joint]), float(share[joint]))


def _of_tool(fit: SequenceFit, one: Demand, known: MotionSettings) -> Iterator[_Guess]:
    for order in range(ORDERS):
        for part in range(2):
            if one.at_tool[order, part]:
                value = float(fit.settings.tool[order, part])
                limit = known.joints.size + 2 * order + part
                yield _Guess(limit, value, value / float(known.tool[order, part]))


def _raised(limits: Array, known: MotionSettings, guesses: Sequence[Sequence[_Guess]]) -> Array:
    """Return limits with tool limits raised where they are guessed to be higher."""
    raised = limits.copy()
    for limit in range(known.joints.size, len(limits)):
        values = [one.value for some in guesses for one in some if one.limit == limit]
        if values and np.median(values) > limits[limit]:
            raised[limit] = np.median(values)
    return raised


def _is_too_quick(replan: Replan, fit: SequenceFit, settings: MotionSettings) -> bool:
    motion = replan(fit.logged.number, settings)
    return motion is not None and motion.duration < (1.0 - _TOO_QUICK) * fit.motion.duration
