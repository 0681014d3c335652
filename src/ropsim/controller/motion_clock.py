"""The motion clock advances along references at any rate up to that of the plan."""

import math
from functools import lru_cache
from threading import get_ident
from typing import NamedTuple, Protocol

import numpy as np

from ropsim.codegen import Compiled, bound
from ropsim.controller.motion_clock_kernel import ClockNumbers, advance_clock
from ropsim.core import RopsimError, Severity, define
from ropsim.flow import JointReference
from ropsim.spatial import Array, record

WRONG_CLOCK_REQUEST = define(
    "C610",
    "wrong-clock-request",
    Severity.ERROR,
    "a motion clock was given an override or limits that it cannot follow",
    """
The motion clock walks through a planned motion at a rate between 0, where the arm stands, and 1, the speed
that was planned. A rate outside of that, a limit of its change that is not above 0, or a number that is not
finite has no meaning for it.

Ask for an override from 0 to 1, and give `ClockLimits` numbers above 0.
""",
)


class ClockError(RopsimError):
    """An invalid request to a motion clock."""


class Rows(Protocol):
    """The references of a motion at control ticks of motion time, computed on request."""

    @property
    def count(self) -> int:
        """Return the number of rows, at least 1: row 0 is the start, the last one the end, at rest."""
        ...

    def rows(self, first: int, last: int) -> JointReference:
        """Return the rows from number `first` up to, without it, number `last`; the same at each call."""
        ...


@record
class ClockState:
    """Where a motion is, at one control tick. Undisturbed, the rate is 1 and does not change.

    Attributes:
        place: motion time in control ticks, 0 to the number of the last row; whole until an intervention.
        rate: motion time that passes per time, 0..1.
        change: of the rate [1/s].
    """

    place: float = 0.0
    rate: float = 1.0
    change: float = 0.0


@record
class ClockLimits:
    """How quickly the rate may follow the override.

    Attributes:
        change: greatest change of the rate [1/s].
        jerk: greatest change of that [1/s²].
        acceleration: greatest joint accelerations [rad/s² | m/s²], shape (n,).

    Raises:
        ClockError: C610, where one of them is not above 0; change and jerk are also finite.
    """

    change: float
    jerk: float
    acceleration: Array

    def __post_init__(self) -> None:
        """Refuse limits that no clock can keep."""
        finite = math.isfinite(self.change) and math.isfinite(self.jerk)
        if not (finite and self.change > 0.0 and self.jerk > 0.0 and bool((self.acceleration > 0.0).all())):
            found = f"change {self.change:g}, jerk {self.jerk:g}, acceleration {self.acceleration}"
            raise ClockError(WRONG_CLOCK_REQUEST.at(None, f"limits are {found}, allowed are numbers above 0"))


def advance(
    state: ClockState, rows: Rows, ticks: int, override: float, limits: ClockLimits, period: float
) -> tuple[ClockState, JointReference]:
    """Advance by some control ticks and return the references on the way.

    With motion time φ, rate w = dφ/dt and its change c = dw/dt the references are q(φ), q'·w and
    q''·w² + q'·c. The rate goes to the override in least time, within change and jerk, and never beyond it.
    It does so no quicker than lets every joint keep its acceleration limit, where the rows alone keep it:
    c = 0 is always possible, and a change is made only if full jerk can take it to 0 again in time. Where a
    joint brakes at its limit, the motion can therefore not be held any sooner than that lasts.

    Undisturbed, with rate and override at 1, the rows themselves are handed out. Once disturbed, the place
    may lie between two rows, where the polynomial of fifth degree through both holds, and stays so until the
    end. However ticks are cut into calls, references and states are the same, bit by bit.

    That a motion has a time of its own, which limits may slow down, is from Dahl and Nielsen.

    Args:
        state: where the motion is.
        rows: its references.
        ticks: number of ticks, 1 or more.
        override: rate that is requested, 0 (hold) to 1, from now on.
        limits: of the rate.
        period: of a control tick [s].

    Returns:
        the state after these ticks, and a row of reference for each of them, the first one a control period
        after `state`. The place ends at that of the last row, and the references are at rest there; the rate
        goes on.

    Raises:
        ClockError: C610, where the override is not within 0..1 or there are no ticks.

    References:
        Dahl and Nielsen 1990, Torque-limited path following by on-line trajectory time scaling, IEEE
        Transactions on Robotics and Automation 6(5).
    """
    if not (0.0 <= override <= 1.0 and ticks >= 1):
        found = f"override is {override:g} for {ticks} ticks, allowed is 0 to 1 for 1 tick or more"
        raise ClockError(WRONG_CLOCK_REQUEST.at(None, found))
    whole = int(state.place)
    if override == 1.0 and state.rate == 1.0 and state.change == 0.0 and whole == state.place:
        return undisturbed(state, rows, ticks)
    return _advanced(state, rows, ticks, override, limits, period)


def undisturbed(state: ClockState, rows: Rows, ticks: int) -> tuple[ClockState, JointReference]:
    """Advance from a row at full rate: the next rows themselves; behind the last one the motion stands.

    Args:
        state: where the motion is; its place is whole, its rate 1 and does not change.
        rows: its references.
        ticks: number of ticks, 1 or more.

    Returns:
        as `advance`.
    """
    place = int(state.place)
    end, count = place + ticks, rows.count
    if end < count:
        return ClockState(float(end)), rows.rows(place + 1, end + 1)
    given = rows.rows(place, count)
    stands = end - count + 1
    q = np.concatenate((given.q[1:], np.repeat(given.q[-1:], stands, axis=0)))
    still = np.zeros((stands, q.shape[1]))
    qd, qdd = (np.concatenate((one[1:], still)) for one in (given.qd, given.qdd))
    return ClockState(float(count - 1)), JointReference(q, qd, qdd)


def _advanced(
    state: ClockState, rows: Rows, ticks: int, override: float, limits: ClockLimits, period: float
) -> tuple[ClockState, JointReference]:
    """Return the result of the compiled loop on the rows within reach and look-ahead."""
    first, step = int(state.place), limits.jerk * period
    last = min(first + ticks + _lookahead(state, ticks, override, limits, step) + 2, rows.count)
    given, many = rows.rows(first, last), last - first
    bench = _bench(get_ident(), ticks, 1 << many.bit_length(), given.q.shape[1])
    bench.q[:many], bench.qd[:many], bench.qdd[:many] = given.q, given.qd, given.qdd
    bench.limits[:] = limits.acceleration
    clock = ClockNumbers(first, rows.count - 1, override, limits.change, step, period)
    bench.advance_clock(clock, state.place, state.rate, state.change)
    q, qd, qdd = bench.out[:, :ticks].copy()
    return ClockState(*bench.out[:, ticks, 0].tolist()), JointReference(q, qd, qdd)


def _lookahead(state: ClockState, ticks: int, override: float, limits: ClockLimits, step: float) -> int:
    """Return the number of ticks in which full jerk reduces to 0 any change built up within `ticks`."""
    now = abs(state.change)
    if state.rate == override and now == 0.0:
        return 0
    greatest = max(min(now + step * ticks, limits.change), now)
    return math.ceil(greatest / step) + 1


class _Bench(NamedTuple):
    """Arrays shared by calls; their contents do not persist between calls.

    Attributes:
        q: coordinates of the rows that are known, as `qd` and `qdd` their derivatives.
        qd: [rad/s | m/s].
        qdd: [rad/s² | m/s²].
        limits: of the joint accelerations [rad/s² | m/s²].
        out: results.
        advance_clock: the compiled loop on these arrays.
    """

    q: Array
    qd: Array
    qdd: Array
    limits: Array
    out: Array
    advance_clock: Compiled


@lru_cache(maxsize=64)
def _bench(_thread: int, ticks: int, size: int, n: int) -> _Bench:
    """Return the bench of a thread, as compiled code lets other threads go on meanwhile."""
    rows, limits, out = np.zeros((3, size, n)), np.zeros(n), np.zeros((3, ticks + 1, n))
    return _Bench(rows[0], rows[1], rows[2], limits, out, bound(advance_clock, rows, limits, out))
