"""Laws of the motion clock over random motions and random overrides."""

import numpy as np
import ruckig
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.controller import ClockLimits, ClockState, advance
from ropsim.flow import JointReference
from support.examples import examples
from support.walked_rows import ACCELERATION, PERIOD, SPEED, KeptRows, joined, s_curve, same_bits, times, walk

ROUNDING = 1e-9  # relative; sums over some thousand ticks
SAME_PLACE = 1e-9  # ticks; likewise

ways = st.lists(st.floats(-2.5, 2.5), min_size=1, max_size=7).filter(lambda all_: max(map(abs, all_)) > 0.01)
motions = ways.map(s_curve)
asked = st.one_of(st.sampled_from([0.0, 1.0]), st.floats(0.0, 1.0))
overrides = st.lists(st.tuples(st.integers(1, 150), asked), min_size=1, max_size=8)
changes = st.floats(0.5, 50.0)
jerks = st.floats(5.0, 5000.0)


def limits_of(rows: KeptRows, change: float, jerk: float) -> ClockLimits:
    return ClockLimits(change, jerk, np.full(rows.reference.q.shape[1], ACCELERATION))


@settings(max_examples=examples(60), derandomize=True, deadline=None)
@given(motions, overrides, changes, jerks, st.lists(st.integers(0, 60), min_size=1, max_size=30))
def test_however_ticks_are_cut_into_calls_the_bits_are_the_same(
    rows: KeptRows, asked_for: list[tuple[int, float]], change: float, jerk: float, cuts: list[int]
) -> None:
    limits = limits_of(rows, change, jerk)
    each = walk(rows, asked_for, limits)
    now, parts, turn = ClockState(), [], 0
    for ticks, override in asked_for:
        left = ticks
        while left:
            count = min(cuts[turn % len(cuts)] or 1, left)
            now, part = advance(now, rows, count, override, limits, PERIOD)
            parts.append(part)
            left, turn = left - count, turn + 1
    assert now == each.states[-1]
    assert same_bits(joined(parts), each.reference)


@settings(max_examples=examples(100), derandomize=True, deadline=None)
@given(motions, overrides, changes, jerks)
def test_the_rate_keeps_its_limits_and_stays_between_what_was_asked_for(
    rows: KeptRows, asked_for: list[tuple[int, float]], change: float, jerk: float
) -> None:
    found = walk(rows, asked_for, limits_of(rows, change, jerk))
    rates, rate_changes = found.rates, found.changes
    assert rates.min() >= min(1.0, *(one for _, one in asked_for)) - ROUNDING
    assert rates.max() <= 1.0
    assert rates.min() >= 0.0
    assert np.abs(rate_changes).max() <= change
    assert np.abs(np.diff(rate_changes)).max() <= jerk * PERIOD * (1.0 + ROUNDING)
    np.testing.assert_allclose(
        np.diff(rates), (rate_changes[1:] + rate_changes[:-1]) / 2.0 * PERIOD, rtol=0.0, atol=1e-11
    )


@settings(max_examples=examples(100), derandomize=True, deadline=None)
@given(motions, overrides, changes, jerks)
def test_the_place_is_the_integral_of_the_rate_and_never_behind_the_end(
    rows: KeptRows, asked_for: list[tuple[int, float]], change: float, jerk: float
) -> None:
    found = walk(rows, asked_for, limits_of(rows, change, jerk))
    w, c = found.rates, found.changes
    middle = w[:-1] + PERIOD * (3.0 * c[:-1] + c[1:]) / 8.0  # the rate is of second degree: Simpson is exact
    places = np.concatenate(([0.0], np.cumsum((w[:-1] + 4.0 * middle + w[1:]) / 6.0)))
    last = rows.count - 1
    np.testing.assert_allclose(found.places, np.minimum(places, last), rtol=0.0, atol=SAME_PLACE)
    assert (np.diff(found.places) >= 0.0).all()
    assert found.places.max() <= last


@settings(max_examples=examples(150), derandomize=True, deadline=None)
@given(motions, overrides, changes, jerks)
def test_no_joint_passes_the_limits_that_the_rows_keep(
    rows: KeptRows, asked_for: list[tuple[int, float]], change: float, jerk: float
) -> None:
    found = walk(rows, asked_for, limits_of(rows, change, jerk)).reference
    assert np.abs(rows.reference.qdd).max() <= ACCELERATION * (1.0 + ROUNDING)
    assert np.abs(found.qdd).max() <= ACCELERATION * (1.0 + ROUNDING)
    assert np.abs(found.qd).max() <= SPEED * (1.0 + ROUNDING)


polynomials = st.lists(st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6), min_size=1, max_size=4).map(
    np.array
)


@settings(max_examples=examples(60), derandomize=True, deadline=None)
@given(polynomials, overrides, changes, jerks)
def test_references_are_those_of_the_motion_at_its_own_time(
    factors: np.ndarray, asked_for: list[tuple[int, float]], change: float, jerk: float
) -> None:
    """Polynomials of fifth degree, of which the one between two rows is the same."""
    motions_ = [np.polynomial.Polynomial(one) for one in factors]
    t = times(800)
    derivatives = [[one.deriv(k) for one in motions_] for k in range(5)]
    at = [np.array([one(t) for one in row]).T for row in derivatives]
    rows = KeptRows(JointReference(at[0], at[1], at[2]))
    limits = ClockLimits(change, jerk, np.full(len(factors), np.inf))
    found = walk(rows, asked_for, limits)
    inside = found.places[1:] < rows.count - 1  # these motions end at speed; behind the end the clock stands
    phi = found.places[1:] * PERIOD
    w, c = found.rates[1:, None], found.changes[1:, None]
    q, v, a = (np.array([one(phi) for one in row]).T for row in derivatives[:3])
    # speeds and accelerations stay within those of the rows beside: at a peak by up to f''·T²/8 less
    less_v = np.abs(at[3]).max() * PERIOD**2 / 8.0 + 1e-11
    less_a = np.abs(at[4]).max() * PERIOD**2 / 8.0 + 1e-7
    assert np.abs(found.reference.q - q)[inside].max(initial=0.0) <= 1e-13
    assert np.abs(found.reference.qd - v * w)[inside].max(initial=0.0) <= less_v
    wanted = a * w**2 + v * c
    assert np.abs(found.reference.qdd - wanted)[inside].max(initial=0.0) <= less_a + less_v * change


@settings(max_examples=examples(60), derandomize=True, deadline=None)
@given(motions, overrides, changes, jerks)
def test_a_motion_that_was_disturbed_comes_to_its_end_at_rest(
    rows: KeptRows, asked_for: list[tuple[int, float]], change: float, jerk: float
) -> None:
    limits = limits_of(rows, change, jerk)
    state = walk(rows, asked_for, limits).states[-1]
    while state.place < rows.count - 1:
        state, part = advance(state, rows, 64, 1.0, limits, PERIOD)
    state, part = advance(state, rows, 3, 0.4, limits, PERIOD)
    assert state.place == rows.count - 1
    assert (part.q == rows.reference.q[-1]).all()
    assert not part.qd.any()
    assert not part.qdd.any()


@settings(max_examples=examples(100), derandomize=True, deadline=None)
@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), changes, jerks)
def test_the_override_is_reached_in_the_least_time(
    before: float, override: float, change: float, jerk: float
) -> None:
    """Ruckig, told to change a speed, is no quicker, but for the whole ticks in which the clock counts."""
    request = ruckig.InputParameter(1)
    request.control_interface = ruckig.ControlInterface.Velocity
    request.current_velocity, request.target_velocity = [before], [override]
    request.max_acceleration, request.max_jerk = [change], [jerk]
    oracle = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(request, oracle)
    rows = s_curve([2.5])
    least = oracle.duration / PERIOD
    state = ClockState(0.0, before, 0.0)
    limits = ClockLimits(change, jerk, np.full(1, np.inf))
    found = walk(rows, [(int(least) + 4, override)], limits, state=state)
    reached = np.flatnonzero((found.rates == override) & (found.changes == 0.0))[0]
    assert least - 1.0 <= reached <= least + 3.0
    assert (found.rates[reached:] == override).all()
