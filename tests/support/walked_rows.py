"""Motions as reference rows, and walks through them: what tests of the motion clock share."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np

from ropsim.controller import ClockLimits, ClockState, Rows, advance
from ropsim.flow import JointReference
from ropsim.motion import ProfileLimits, evaluate, plan_profile
from ropsim.spatial import Array

PERIOD = 1e-3
SPEED, ACCELERATION, JERK = 3.0, 10.0, 200.0
"""Limits of the joints of the S-curves."""


@dataclass(frozen=True)
class KeptRows:
    """Rows that are all there; nobody may ask for others, and an array holds no more than was asked for."""

    reference: JointReference

    @property
    def count(self) -> int:
        return self.reference.ticks

    def rows(self, first: int, last: int) -> JointReference:
        assert 0 <= first < last <= self.count
        one = self.reference
        return JointReference(*(part[first:last].copy() for part in (one.q, one.qd, one.qdd)))


@dataclass(frozen=True)
class Walk:
    """States at all ticks, the first included, and the references between them."""

    states: list[ClockState]
    reference: JointReference

    @property
    def places(self) -> Array:
        return np.array([one.place for one in self.states])

    @property
    def rates(self) -> Array:
        return np.array([one.rate for one in self.states])

    @property
    def changes(self) -> Array:
        return np.array([one.change for one in self.states])


def times(ticks: int, period: float = PERIOD) -> Array:
    """Return the motion time of row 0 and of so many more [s], shape (ticks + 1,)."""
    return np.arange(ticks + 1, dtype=np.float64) * period


def s_curve(ways: Sequence[float], period: float = PERIOD) -> KeptRows:
    """Return a move from zero along the given ways of the joints, which are not all 0, within the limits."""
    longest = float(np.abs(ways).max())
    profile = plan_profile(1.0, ProfileLimits(SPEED / longest, ACCELERATION / longest, JERK / longest))
    ticks = max(ceil(profile.duration / period), 1)
    rate = profile.duration / (ticks * period)
    r, rd, rdd = evaluate(profile, rate * times(ticks, period))
    return KeptRows(JointReference(*(np.outer(one, ways) for one in (r, rate * rd, rate**2 * rdd))))


def walk(
    rows: Rows,
    overrides: Sequence[tuple[int, float]],
    limits: ClockLimits,
    period: float = PERIOD,
    state: ClockState | None = None,
) -> Walk:
    """Walk tick by tick: so many ticks with one override, so many with the next one."""
    now = state or ClockState()
    states, parts = [now], []
    for ticks, override in overrides:
        for _ in range(ticks):
            now, part = advance(now, rows, 1, override, limits, period)
            states.append(now)
            parts.append(part)
    return Walk(states, joined(parts))


def joined(parts: Sequence[JointReference]) -> JointReference:
    """Return references one after the other."""
    q, qd, qdd = (np.concatenate([getattr(one, name) for one in parts]) for name in ("q", "qd", "qdd"))
    return JointReference(q, qd, qdd)


def same_bits(one: JointReference, two: JointReference) -> bool:
    """Return whether two references have the same bits, those of zeros included."""
    return all(getattr(one, name).tobytes() == getattr(two, name).tobytes() for name in ("q", "qd", "qdd"))
