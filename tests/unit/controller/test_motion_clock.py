"""The motion clock: undisturbed, held, slowed, at its end, and at the limits of joints."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import inf, nan

import numpy as np
import pytest

from ropsim.controller import ClockError, ClockLimits, ClockState, advance, motion_clock
from ropsim.controller.motion_clock_kernel import ClockNumbers
from ropsim.controller.motion_clock_kernel import advance_clock as walk_kernel
from ropsim.flow import JointReference
from ropsim.spatial import Array
from support.in_python import in_python
from support.walked_rows import ACCELERATION, PERIOD, KeptRows, joined, s_curve, same_bits, times, walk

MOVE = s_curve([1.5, -0.7, 0.2])
LAST = MOVE.count - 1
LIMITS = ClockLimits(5.0, 200.0, np.full(3, ACCELERATION))
FREE = ClockLimits(5.0, 200.0, np.full(3, inf))
ROUNDING = 1e-12


def of_one_joint(q: Array, qd: Array, qdd: Array) -> KeptRows:
    return KeptRows(JointReference(q[:, None], qd[:, None], qdd[:, None]))


def at_constant_speed(speed: float, ticks: int) -> KeptRows:
    t = times(ticks)
    return of_one_joint(speed * t, np.full(ticks + 1, speed), np.zeros(ticks + 1))


@pytest.mark.parametrize("ticks", [1, 4, 333])
def test_undisturbed_the_rows_themselves_come_out(ticks: int) -> None:
    state, parts = ClockState(), []
    while state.place + ticks <= LAST:
        state, part = advance(state, MOVE, ticks, 1.0, LIMITS, PERIOD)
        parts.append(part)
    whole = joined(parts)
    assert state == ClockState(float(whole.ticks))
    assert same_bits(whole, MOVE.rows(1, whole.ticks + 1))


def test_behind_the_end_the_motion_stands_at_its_last_row() -> None:
    state, part = advance(ClockState(LAST - 2.0), MOVE, 5, 1.0, LIMITS, PERIOD)
    assert state == ClockState(float(LAST))
    assert same_bits(KeptRows(part).rows(0, 2), MOVE.rows(LAST - 1, LAST + 1))
    assert (part.q[2:] == MOVE.reference.q[-1]).all()
    assert not part.qd[2:].any()
    assert not part.qdd[2:].any()
    again, still = advance(state, MOVE, 2, 1.0, LIMITS, PERIOD)
    assert again == state
    assert (still.q == MOVE.reference.q[-1]).all()


@pytest.mark.parametrize("override", [0.0, 0.6, 1.0])
def test_a_motion_of_one_row_is_at_its_end(override: float) -> None:
    rows = KeptRows(MOVE.rows(LAST, LAST + 1))
    state, part = advance(ClockState(), rows, 3, override, LIMITS, PERIOD)
    assert state.place == 0.0
    assert (part.q == rows.reference.q[0]).all()
    assert part.ticks == 3
    assert not part.qd.any()


def test_a_held_motion_stands_exactly_and_goes_on_from_there() -> None:
    found = walk(MOVE, [(100, 1.0), (400, 0.0), (800, 1.0)], FREE)
    held = found.states[500]
    assert (held.rate, held.change) == (0.0, 0.0)
    assert 100.0 < held.place < 500.0
    assert not found.reference.qd[499].any()
    assert not found.reference.qdd[499].any()
    short = walk(MOVE, [(100, 1.0), (390, 0.0), (800, 1.0)], FREE)
    assert short.states[490] == held
    assert same_bits(KeptRows(found.reference).rows(500, 1300), KeptRows(short.reference).rows(490, 1290))
    assert found.states[-1] == ClockState(float(LAST))


def test_the_first_tick_after_a_hold_is_already_slower() -> None:
    """Within one tick the change is as far as jerk lets it be."""
    state, _ = advance(ClockState(100.0), MOVE, 1, 0.0, FREE, PERIOD)
    assert state.change == -FREE.jerk * PERIOD
    assert state.rate < 1.0


def test_back_at_full_rate_the_place_stays_between_two_rows_and_the_path_is_kept() -> None:
    found = walk(MOVE, [(100, 1.0), (30, 0.5), (400, 1.0)], FREE)
    state = found.states[-1]
    assert (state.rate, state.change) == (1.0, 0.0)
    u = state.place - int(state.place)
    assert 0.0 < u < 1.0
    before, behind = (MOVE.reference.q[int(state.place) + one] for one in (0, 1))
    inside = np.minimum(before, behind) <= found.reference.q[-1]
    assert (inside & (found.reference.q[-1] <= np.maximum(before, behind))).all()


def test_a_half_rate_from_a_row_on_comes_to_every_row() -> None:
    """Positions are those of the rows, speeds half, accelerations a quarter of theirs."""
    state, found = advance(ClockState(200.0, 0.5), MOVE, 40, 0.5, LIMITS, PERIOD)
    rows = MOVE.rows(201, 221)
    assert state == ClockState(220.0, 0.5)
    assert (found.q[1::2] == rows.q).all()
    assert (found.qd[1::2] == rows.qd * 0.5).all()
    assert (found.qdd[1::2] == rows.qdd * 0.25).all()


def test_a_hold_is_as_quick_as_the_joint_accelerations_let_it_be() -> None:
    speed = 2.0
    limits = ClockLimits(50.0, 5000.0, np.full(1, ACCELERATION))
    found = walk(at_constant_speed(speed, 900), [(50, 1.0), (500, 0.0), (300, 1.0)], limits)
    strongest = np.abs(found.reference.qdd).max()
    assert 0.98 * ACCELERATION <= strongest <= ACCELERATION * (1.0 + ROUNDING)
    at_rest = np.flatnonzero(found.rates == 0.0)[0]
    shortest = speed / ACCELERATION / PERIOD  # ticks from full speed to rest at the limit
    assert shortest <= at_rest - 50 <= 1.1 * shortest


def test_the_strictest_joint_counts() -> None:
    t = times(900)
    speeds = np.array([2.0, 0.5, -1.0])
    rows = KeptRows(JointReference(t[:, None] * speeds, np.tile(speeds, (901, 1)), np.zeros((901, 3))))
    limits = ClockLimits(50.0, 5000.0, np.array([20.0, 8.0, 4.0]))
    found = np.abs(walk(rows, [(400, 0.0)], limits).reference.qdd).max(axis=0)
    np.testing.assert_allclose(found / found[2], np.abs(speeds), rtol=1e-9)
    assert 0.95 * 4.0 <= found[2] <= 4.0 * (1.0 + ROUNDING)


def test_a_joint_that_brakes_at_its_limit_is_not_braked_any_more() -> None:
    ticks = 300
    t = times(ticks)
    left = t[-1] - t
    rows = of_one_joint(-0.5 * ACCELERATION * left**2, ACCELERATION * left, np.full(ticks + 1, -ACCELERATION))
    limits = ClockLimits(50.0, 5000.0, np.full(1, ACCELERATION))
    found = walk(rows, [(ticks - 1, 0.0)], limits)
    assert (found.rates == 1.0).all()
    assert same_bits(found.reference, rows.rows(1, ticks))


def test_a_joint_that_speeds_up_at_its_limit_may_brake_with_twice_of_it() -> None:
    ticks = 500
    t = times(ticks)
    rows = of_one_joint(0.5 * ACCELERATION * t**2, ACCELERATION * t, np.full(ticks + 1, ACCELERATION))
    limits = ClockLimits(50.0, 5000.0, np.full(1, ACCELERATION))
    found = walk(rows, [(200, 1.0), (20, 0.0)], limits)
    assert found.rates[-1] < 1.0
    fastest = -2.0 * ACCELERATION / found.reference.qd[199, 0]
    assert fastest * 1.2 < found.changes.min() < fastest * 0.8


def test_a_limit_ahead_is_seen_before_jerk_could_no_longer_keep_it() -> None:
    """A joint at speed suddenly begins to brake at its limit: by then the rate must stand still."""
    before, braking = 200, 200
    t = times(before + braking)
    speed = ACCELERATION * braking * PERIOD
    late = np.maximum(t - before * PERIOD, 0.0)
    rows = of_one_joint(
        speed * t - 0.5 * ACCELERATION * late**2,
        speed - ACCELERATION * late,
        np.where(t > before * PERIOD - PERIOD / 2.0, -ACCELERATION, 0.0),
    )
    limits = ClockLimits(2.0, 40.0, np.full(1, ACCELERATION))  # 50 ticks from the greatest change to none
    found = walk(rows, [(180, 1.0), (221, 0.0)], limits)
    assert found.rates[220] < 1.0
    assert np.abs(found.reference.qdd).max() <= ACCELERATION * (1.0 + ROUNDING)


def test_rows_beyond_a_limit_are_told_as_they_are_and_made_no_worse() -> None:
    limits = ClockLimits(5.0, 200.0, np.full(3, 0.5 * ACCELERATION))
    found = walk(MOVE, [(60, 1.0), (60, 0.3), (60, 1.0)], limits)
    assert np.abs(MOVE.reference.qdd).max() > 0.9 * ACCELERATION
    assert np.abs(found.reference.qdd).max() <= np.abs(MOVE.reference.qdd).max() * (1.0 + ROUNDING)
    assert found.rates[120] < 0.9


def test_an_override_that_returns_while_the_rate_falls_is_followed_without_going_beyond() -> None:
    found = walk(MOVE, [(100, 1.0), (60, 0.0), (200, 0.9), (10, 0.2), (300, 1.0)], FREE)
    assert found.rates.max() == 1.0
    assert found.rates[361 - 1] == 0.9
    assert found.rates.min() > 0.2
    assert found.rates[-1] == 1.0


@dataclass
class Asked:
    """The rows of the move, and the last of them that was asked for."""

    last: int = 0
    count = MOVE.count

    def rows(self, first: int, last: int) -> JointReference:
        self.last = last
        return MOVE.rows(first, last)


def looped(known: Array, state: ClockState, ticks: int, override: float, limits: ClockLimits) -> Array:
    """Return what the loop makes of rows of the move that are all there, shape (3, ticks, n)."""
    out = np.empty((3, ticks + 1, 3))
    now = state.place, state.rate, state.change
    step = limits.jerk * PERIOD
    clock = ClockNumbers(0, LAST, override, limits.change, step, PERIOD)
    walk_kernel(known, limits.acceleration, out, clock, *now)
    return out[:, :ticks]


ALL_ROWS = np.stack((MOVE.reference.q, MOVE.reference.qd, MOVE.reference.qdd))


@pytest.mark.parametrize(("change", "jerk"), [(5.0, 200.0), (50.0, 20.0), (0.5, 0.5), (30.0, 30000.0)])
@pytest.mark.parametrize("override", [0.0, 0.4, 0.999])
@pytest.mark.parametrize("place", [0.0, 120.0, 123.4, 700.0])
def test_as_many_rows_are_asked_for_as_are_looked_at(
    change: float, jerk: float, override: float, place: float
) -> None:
    """Whatever stands behind them makes no difference."""
    limits = ClockLimits(change, jerk, np.full(3, ACCELERATION))
    for state in (ClockState(place), ClockState(place, 0.7), ClockState(place, 0.5, 3.0)):
        for ticks in (1, 7, 300):
            rows, others = Asked(), ALL_ROWS.copy()
            _, found = advance(state, rows, ticks, override, limits, PERIOD)
            others[:, rows.last :] = 1e9
            assert same_bits(found, JointReference(*looped(ALL_ROWS, state, ticks, override, limits)))
            assert same_bits(found, JointReference(*looped(others, state, ticks, override, limits)))


def test_at_full_rate_and_on_a_row_the_loop_hands_out_the_rows_themselves() -> None:
    """So it makes no difference which of two ways a call goes, not even in the signs of zeros."""
    assert np.signbit(MOVE.reference.qdd[-1]).any()
    for place in (LAST - 3.0, float(LAST)):
        _, found = advance(ClockState(place), MOVE, 6, 1.0, LIMITS, PERIOD)
        assert same_bits(found, JointReference(*looped(ALL_ROWS, ClockState(place), 6, 1.0, LIMITS)))


def test_a_rate_of_1_that_falls_is_not_undisturbed() -> None:
    state, _ = advance(ClockState(100.0, 1.0, -0.5), MOVE, 1, 1.0, LIMITS, PERIOD)
    assert 0.999 < state.rate < 1.0
    assert state.change > -0.5


def test_a_change_beyond_a_limit_that_was_lowered_falls_with_full_jerk() -> None:
    found = walk(
        MOVE, [(40, 1.0)], ClockLimits(1.0, 200.0, np.full(3, inf)), state=ClockState(90.0, 0.2, 3.0)
    )
    np.testing.assert_allclose(found.changes[:12], [*(3.0 - 0.2 * np.arange(11)), 1.0], rtol=1e-12)


def test_between_rows_that_do_not_fit_together_no_speed_is_beyond_theirs() -> None:
    q = np.array([0.0, 1.3, 2.0]) * PERIOD
    rows = of_one_joint(q, np.ones(3), np.zeros(3))
    state, found = advance(ClockState(0.5), rows, 1, 1.0, ClockLimits(5.0, 200.0, np.ones(1)), PERIOD)
    assert state.place == 1.5
    assert found.qd[0, 0] == 1.0
    assert found.qdd[0, 0] == 0.0


def test_walks_of_several_threads_do_not_meet() -> None:
    asked = [(100, 1.0), (300, 0.2), (300, 1.0)]
    moves = [MOVE, s_curve([-1.0, 0.4, 2.0]), s_curve([0.1, 2.2, -0.9]), s_curve([0.7, 0.7, 0.7])]
    alone = [walk(one, asked, LIMITS) for one in moves]
    with ThreadPoolExecutor(len(moves)) as pool:
        together = list(pool.map(lambda one: walk(one, asked, LIMITS), moves))
    for one, other in zip(alone, together, strict=True):
        assert other.states == one.states
        assert same_bits(other.reference, one.reference)


def test_in_plain_python_the_references_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = [(40, 1.0), (60, 0.0), (40, 0.8), (40, 1.0)]
    compiled = walk(MOVE, asked, LIMITS)
    plain = in_python(walk_kernel)
    monkeypatch.setattr(motion_clock, "advance_clock", plain)
    monkeypatch.setattr(motion_clock, "_bench", motion_clock._bench.__wrapped__)
    found = walk(MOVE, asked, LIMITS)
    assert found.states == compiled.states
    assert (found.reference.q == compiled.reference.q).all()
    assert (found.reference.qd == compiled.reference.qd).all()
    assert (found.reference.qdd == compiled.reference.qdd).all()


@pytest.mark.parametrize("override", [-0.1, 1.0 + 1e-9, nan, inf])
def test_an_override_that_is_none_is_refused(override: float) -> None:
    with pytest.raises(ClockError, match="C610"):
        advance(ClockState(), MOVE, 1, override, LIMITS, PERIOD)


@pytest.mark.parametrize("ticks", [0, -1])
def test_a_walk_of_no_ticks_is_refused(ticks: int) -> None:
    with pytest.raises(ClockError, match=f"for {ticks} ticks"):
        advance(ClockState(), MOVE, ticks, 1.0, LIMITS, PERIOD)


@pytest.mark.parametrize(
    ("change", "jerk", "acceleration"),
    [(0.0, 1.0, 1.0), (1.0, 0.0, 1.0), (inf, 1.0, 1.0), (1.0, nan, 1.0), (1.0, 1.0, 0.0), (1.0, 1.0, nan)],
)
def test_limits_that_nothing_can_keep_are_refused(change: float, jerk: float, acceleration: float) -> None:
    with pytest.raises(ClockError, match="above 0"):
        ClockLimits(change, jerk, np.array([5.0, acceleration]))
