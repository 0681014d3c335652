"""Which stops of a trace are the stops of a program, in order."""

from collections.abc import Sequence

import numpy as np

from ropsim.calibration.trace.rests import Rests
from ropsim.core import frozen_dataclass
from ropsim.model import Joint, JointType
from ropsim.spatial import Array

_NEAR_TURN, _NEAR_SLIDE = 0.02, 0.01  # [rad], [m]
_FAR_REST = 0.05
"""Cost of a stop in the trace only, relative to the worth of a matching stop."""
_ABSENT = 0.3
"""Cost of a stop in the program only."""
_ROUNDING = 1e-9
"""Difference of two scores that is none."""
_MOST_CELLS = 30_000_000
"""Pairs of stops that are compared at most; beyond that the later stops of the trace are left out."""


@frozen_dataclass
class Passage:
    """A sequence of the program with the part of the trace between its stops.

    Attributes:
        sequence: its number.
        start: number of the stop of the trace at which it begins.
        end: of that at which it ends.
    """

    sequence: int
    start: int
    end: int


def match(rests: Rests, ends: Array, joints: Sequence[Joint]) -> tuple[Passage, ...]:
    """Return the sequences that the trace holds, each once and in order.

    The longest common sequence of both lists of places (Needleman & Wunsch 1970, with free ends of the
    trace): stops that fit are worth most where they are near, stops that only one of the lists has cost a
    little.

    Args:
        rests: of the trace.
        ends: where the program stands, at its start and at the end of each sequence [rad | m], shape (k + 1,
            n).
        joints: of the axes, n of them.
    """
    near = near_of(joints)
    count = min(rests.count, max(2, _MOST_CELLS // len(ends)))
    places = rests.q[:count]
    taken = _aligned(places, ends, near)
    passages = []
    for sequence in range(len(ends) - 1):
        start, end = taken[sequence], taken[sequence + 1]
        if start is None or end is None:
            continue
        passages.append(_nearest(sequence, start, end, places, ends, near))
    return tuple(passages)


def near_of(joints: Sequence[Joint]) -> Array:
    """Return how near two stops are to each other that are one [rad | m], shape (n,)."""
    return np.array([_NEAR_TURN if one.measure is JointType.REVOLUTE else _NEAR_SLIDE for one in joints])


def _aligned(places: Array, ends: Array, near: Array) -> list[int | None]:
    """Return for each stop of the program the number of that of the trace, None for none."""
    count = len(places)
    slope = _FAR_REST * np.arange(count + 1)
    score = np.zeros(count + 1)
    fits = np.empty((len(ends), count), dtype=np.bool_)
    kept = np.empty((len(ends), count), dtype=np.bool_)
    for k, end in enumerate(ends):
        far = (np.abs(places - end) / near).max(axis=1)
        worth = np.where(far < 1.0, 1.0 - 0.5 * far, -np.inf)
        diagonal, above = score[:-1] + worth, score[1:] - _ABSENT
        fits[k] = diagonal >= above
        best = np.concatenate(([score[0] - _ABSENT], np.maximum(diagonal, above)))
        reached = np.maximum.accumulate(best + slope) - slope
        kept[k] = reached[1:] > best[1:] + _ROUNDING
        score = reached
    taken: list[int | None] = [None] * len(ends)
    j, k = int(score.argmax()), len(ends) - 1
    while k >= 0 and j > 0:
        if kept[k, j - 1]:
            j -= 1
        elif fits[k, j - 1]:
            taken[k] = j - 1
            j, k = j - 1, k - 1
        else:
            k -= 1
    return taken


def _nearest(sequence: int, start: int, end: int, places: Array, ends: Array, near: Array) -> Passage:
    """Return the passage between two stops, without pauses at its start and at its end."""
    while start + 1 < end and bool((np.abs(places[start + 1] - ends[sequence]) < near).all()):
        start += 1
    while end - 1 > start and bool((np.abs(places[end - 1] - ends[sequence + 1]) < near).all()):
        end -= 1
    return Passage(sequence, start, end)
