"""The fastest motion along a path: closed forms and a linear program as the oracle."""

import numpy as np
import pytest
from scipy.optimize import linprog

from ropsim.motion import Infeasible, JointBounds, JointPoints, ProfileError, Quantity, time_optimal
from ropsim.motion.testing import MOST_FALL, LinearRows, fastest
from ropsim.spatial import Array
from support.in_python import in_python
from support.motions import Waves, body

ENDLESS = np.inf


def line(m: int, length: float) -> JointPoints:
    """Return one joint that goes a way in m places."""
    s = np.linspace(0.0, length, m)[:, None]
    return JointPoints(s, np.ones((m, 1)), np.zeros((m, 1)))


def bounds(speed: float, acceleration: float, effort: float | None = None) -> JointBounds:
    torque = None if effort is None else np.array([effort])
    return JointBounds(np.array([speed]), np.array([acceleration]), np.array([ENDLESS]), torque)


def speeds_of(found: Array | Infeasible) -> Array:
    assert not isinstance(found, Infeasible), found
    return found


def duration_of(speeds: Array, step: float) -> float:
    return float(np.sum(2.0 * step / (speeds[1:] + speeds[:-1])))


def test_a_double_integrator_takes_twice_the_root_of_way_over_acceleration() -> None:
    """Bang-bang: T = 2·√(L/a)."""
    speeds = speeds_of(time_optimal(line(101, 3.0), 0.03, bounds(ENDLESS, 2.0), None))
    assert duration_of(speeds, 0.03) == pytest.approx(2.0 * np.sqrt(3.0 / 2.0), rel=1e-9)


def test_with_a_speed_limit_it_takes_way_over_speed_and_speed_over_acceleration() -> None:
    """Trapezoid: T = L/v + v/a; speed is reached at a place of the grid."""
    speeds = speeds_of(time_optimal(line(101, 4.0), 0.04, bounds(2.0, 5.0), None))
    assert duration_of(speeds, 0.04) == pytest.approx(4.0 / 2.0 + 2.0 / 5.0, rel=1e-9)


def test_torque_against_gravity_and_dry_friction_gives_two_accelerations() -> None:
    """m·qdd + g + f = ±τ: up with (τ-g-f)/m, down with (τ+g+f)/m; T = √(2·L·(1/a + 1/d))."""
    mass, gravity, friction, most = 2.0, 3.0, 1.0, 10.0
    found = time_optimal(
        line(2001, 1.0),
        5e-4,
        bounds(ENDLESS, ENDLESS, most),
        lambda _q, qd, qdd: mass * qdd + gravity + friction * np.sign(qd),
    )
    up, down = (most - gravity - friction) / mass, (most + gravity + friction) / mass
    expected = np.sqrt(2.0 * (1.0 / up + 1.0 / down))
    assert duration_of(speeds_of(found), 5e-4) == pytest.approx(expected, rel=1e-3)  # ends within the grid


def test_viscous_friction_bounds_the_speed_where_it_takes_all_torque() -> None:
    found = time_optimal(
        line(2001, 100.0), 0.05, bounds(5.0, ENDLESS, 6.0), lambda _q, qd, qdd: qdd + 2.0 * qd
    )
    assert speeds_of(found).max() == pytest.approx(3.0, rel=1e-3)


@pytest.mark.parametrize("seed", range(6))
def test_duration_is_that_of_a_linear_program(seed: int) -> None:
    """All squared speeds x at once: the greatest sum under the same rows."""
    random = np.random.default_rng(seed)
    m, n = 60, 3
    motion = Waves(random, n, 1.0, 1.0, 1.5)
    s = np.linspace(0.0, 1.0, m)
    angle, width = motion._circular * s[:, None, None] + motion._phase, motion._size
    points = JointPoints(
        (width * np.sin(angle)).sum(axis=1),
        (width * motion._circular * np.cos(angle)).sum(axis=1),
        -(width * motion._circular**2 * np.sin(angle)).sum(axis=1),
    )
    most = random.uniform(1.0, 3.0, n)
    found = speeds_of(time_optimal(points, s[1], JointBounds(most, 3.0 * most, most), None))
    step, rows, right = s[1], [], []
    for i in range(m - 1):
        for end in (i, i + 1):
            for j in range(n):
                row = np.zeros(m)
                row[i], row[i + 1] = -points.d1[end, j] / (2.0 * step), points.d1[end, j] / (2.0 * step)
                row[end] += points.d2[end, j]
                rows += [row, -row]
                right += [3.0 * most[j]] * 2
        if i < m - 2:  # the kernel lets x fall by so much from place to place
            row = np.zeros(m)
            row[i], row[i + 1] = 1.0 - MOST_FALL, -1.0
            rows, right = [*rows, row], [*right, 0.0]
    caps = ((most / np.abs(points.d1)).min(axis=1)) ** 2
    caps[0] = caps[-1] = 0.0
    oracle = linprog(-np.ones(m), np.array(rows), right, bounds=list(zip(np.zeros(m), caps, strict=True)))
    assert oracle.status == 0
    best = duration_of(np.sqrt(np.maximum(oracle.x, 0.0)), step)
    assert duration_of(found, step) == pytest.approx(best, rel=2e-3)  # the greatest sum is not the least time


def test_a_place_that_gravity_alone_forbids_is_told() -> None:
    found = time_optimal(line(101, 1.0), 0.01, bounds(1.0, 1.0, 5.0), lambda q, _qd, qdd: qdd + 10.0 * q)
    assert isinstance(found, Infeasible)
    assert (found.joint, found.quantity, found.limit) == (0, Quantity.TORQUE, 5.0)
    assert found.phi == pytest.approx(0.51, abs=1e-9)
    assert found.value == pytest.approx(5.1, abs=1e-9)


def test_paths_and_torques_that_are_no_numbers_are_refused() -> None:
    bad = JointPoints(np.full((5, 1), np.nan), np.ones((5, 1)), np.ones((5, 1)))
    with pytest.raises(ProfileError, match="finite numbers at 2 places"):
        time_optimal(bad, 0.1, bounds(1.0, 1.0), None)
    with pytest.raises(ProfileError, match="steps of 0"):
        time_optimal(line(5, 1.0), 0.0, bounds(1.0, 1.0), None)
    with pytest.raises(ProfileError, match="torques are"):
        time_optimal(line(5, 1.0), 0.25, bounds(1.0, 1.0, 1.0), lambda q, _qd, _qdd: q * np.nan)


def test_the_plain_function_gives_what_the_compiled_one_gives() -> None:
    random, m = np.random.default_rng(4), 40
    A, B = random.normal(size=(2, m, 5))
    lower, upper = -random.uniform(0.0, 3.0, (m, 5)), random.uniform(0.0, 3.0, (m, 5))
    caps, steps = random.uniform(0.5, 1.0, m), random.uniform(0.01, 0.02, m - 1)
    plain, compiled = np.zeros((2, 4, m))
    in_python(fastest)(LinearRows(A, B, lower, upper), caps, steps, *plain)
    fastest(LinearRows(A, B, lower, upper), caps, steps, *compiled)
    assert plain[3] == pytest.approx(compiled[3], rel=1e-12)


@pytest.mark.parametrize("seed", range(10))
def test_what_is_kept_from_the_call_before_is_what_would_be_found_again(seed: int) -> None:
    random, m = np.random.default_rng(seed), 300
    A, B = np.cumsum(random.normal(size=(2, m, 4)) * 0.1, axis=1)
    most, caps, steps = random.uniform(0.5, 3.0, (m, 4)), random.uniform(0.5, 1.0, m), np.full(m - 1, 0.01)
    known = np.zeros((3, m))
    fastest(LinearRows(A, B, -most, most), caps, steps, np.zeros(m), *known)
    for changes in (1, 5, 40):
        same, places = np.ones(m), random.integers(0, m, changes)
        same[places] = 0.0
        caps[places] *= random.uniform(0.5, 1.0, changes)
        most[places] *= random.uniform(0.5, 1.0, (changes, 1))
        again = np.zeros((3, m))
        fastest(LinearRows(A, B, -most, most), caps, steps, same, *known)
        fastest(LinearRows(A, B, -most, most), caps, steps, np.zeros(m), *again)
        assert (known == again).all()


def test_more_torque_never_makes_it_slower() -> None:
    random = np.random.default_rng(5)
    effort, motion = body(random, 3), Waves(random, 3, 1.0, 0.4, 1.0)
    points = motion.at(np.linspace(0.1, 0.9, 101))
    last = np.inf
    for most in (12.0, 15.0, 20.0, 40.0):
        limit = JointBounds(np.full(3, 9.0), np.full(3, ENDLESS), np.full(3, ENDLESS), np.full(3, most))
        duration = duration_of(speeds_of(time_optimal(points, 0.008, limit, effort)), 0.008)
        assert duration <= last * (1.0 + 1e-6)
        last = duration
