"""Motions in their motion time: what they are at control ticks, and when that clearly is within limits."""

import numpy as np
import pytest

from ropsim.motion import JointBounds, JointPoints, ProfileError
from ropsim.motion.testing import (
    AT_ONCE,
    ROWS_OF_LOAD,
    ROWS_OF_RATES,
    beyond_torque,
    evaluate_at,
    keeps_torque,
)
from ropsim.spatial import Array


def walk(first: Array, second: Array, course: Array, limits: Array) -> tuple[Array, float]:
    """Return the speeds and accelerations, and what is beyond limits."""
    out, beyond = np.full((2, *first.shape), np.nan), np.empty(1)
    room = np.empty((ROWS_OF_RATES, AT_ONCE * first.shape[1]))
    evaluate_at(first, second, course, limits, room, out.reshape(2, -1), beyond)
    return out, float(beyond[0])


def motion(seed: int, k: int = 40, n: int = 6) -> tuple[Array, Array, Array]:
    """Return derivatives of joints by motion time, and motion times, rates and their changes."""
    random = np.random.default_rng(seed)
    return random.normal(size=(k, n)), random.normal(size=(k, n)), random.uniform(0.1, 1.0, (3, k))


@pytest.mark.parametrize("n", [1, 6, 9])
def test_speeds_and_accelerations_are_those_by_real_time_and_the_most_beyond_limits_is_told(n: int) -> None:
    first, second, course = motion(n, n=n)
    limits = np.random.default_rng(9).uniform(0.5, 2.0, (3, n))
    out, beyond = walk(first, second, course, limits)
    w, c = course[1][:, None], course[2][:, None]
    expected = np.stack((first * w, second * (w * w) + first * c))
    assert (out == expected).all()
    jumps = np.abs(np.diff(out[1], axis=0, prepend=0.0, append=0.0))
    sizes = np.abs(out[0]), np.abs(out[1]), jumps
    assert beyond == max((size - limit).max() for size, limit in zip(sizes, limits, strict=True))


@pytest.mark.parametrize("tick", [0, 17, 39])
@pytest.mark.parametrize("kind", range(3))
def test_one_number_beyond_one_limit_is_seen_wherever_it_is(kind: int, tick: int) -> None:
    """A jump of acceleration counts on the way to the first tick, and from the last one on."""
    first, second, course = np.full((40, 6), 0.1), np.full((40, 6), 0.0), np.ones((3, 40))
    course[2] = 0.0
    limits = np.ones((3, 6))
    assert walk(first, second, course, limits)[1] < 0.0
    (first if kind == 0 else second)[tick, 4] = 1.5
    loose = np.full((3, 6), np.inf)
    loose[kind] = 1.0
    assert walk(first, second, course, loose)[1] == 0.5


def test_joints_rest_behind_the_last_tick() -> None:
    """An acceleration that rises in small steps is taken back at once there."""
    first, second, course = np.zeros((40, 6)), np.zeros((40, 6)), np.ones((3, 40))
    second[:, 2], course[2] = np.linspace(0.0, 1.5, 40), 0.0
    limits = np.full((3, 6), np.inf)
    limits[2] = 1.0
    assert walk(first, second, course, limits)[1] == 0.5


@pytest.mark.parametrize("k", [1, AT_ONCE, AT_ONCE + 1, 100])
def test_torque_is_beyond_its_limit_by_the_most_of_all_rows(k: int) -> None:
    random = np.random.default_rng(k)
    torque, limit = random.normal(size=(k, 6)), random.uniform(0.5, 2.0, 6)
    beyond = np.empty(1)
    beyond_torque(torque.reshape(-1), limit, np.empty((ROWS_OF_LOAD, AT_ONCE * 6)), beyond)
    assert beyond[0] == (np.abs(torque) - limit).max()


def test_torque_that_is_its_limit_but_for_rounding_is_kept_and_no_number_is_an_error() -> None:
    rows, most = JointPoints(*np.zeros((3, 30, 2))), np.array([2.0, np.inf])
    bounds, torque = JointBounds(np.ones(2), np.ones(2), np.ones(2), most), np.full((30, 2), -2.0)
    assert keeps_torque(rows, bounds, lambda *_: torque)
    torque[29, 0] = 2.0 * (1.0 + 2e-9)
    assert not keeps_torque(rows, bounds, lambda *_: torque)
    torque[29, 1] = np.nan
    with pytest.raises(ProfileError, match="allowed are finite numbers"):
        keeps_torque(rows, bounds, lambda *_: torque)
