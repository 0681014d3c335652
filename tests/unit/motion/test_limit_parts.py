"""Parts that the keeping of limits is made of: strains, rates that are needed, places, refusals."""

import numpy as np
import pytest

from ropsim.motion import (
    Infeasible,
    JointBounds,
    JointPoints,
    PathMotion,
    ProfileError,
    Quantity,
    constraint_rows,
    no_path_motion,
    retime,
    time_optimal,
)
from ropsim.motion.testing import (
    Going,
    Speeds,
    binding_constraint,
    grid_points_of,
    rates_needed,
    utilisation_as_planned,
    utilisation_of_rows,
    with_torque,
)
from ropsim.motion.testing import utilisation_kernel as strain_kernel
from ropsim.spatial import Array
from support.motions import Passing, Waves, body

BOUNDS = JointBounds(np.array([2.0]), np.array([4.0]), np.array([100.0]), np.array([5.0]))


def test_acceleration_that_does_not_begin_and_end_at_0_is_jerk_at_the_first_and_last_tick() -> None:
    rows = JointPoints(np.zeros((4, 1)), np.zeros((4, 1)), np.array([[1.0], [1.0], [1.0], [3.0]]))
    used = utilisation_of_rows(rows, None, BOUNDS, 0.01).used
    assert used[2] == pytest.approx([1.0, 0.0, 0.0, 3.0])


def test_the_rows_of_strains_are_those_of_the_quantities() -> None:
    rows = {quantity.name: getattr(strain_kernel, quantity.name) for quantity in Quantity}
    assert list(rows.values()) == list(range(len(Quantity)))


def test_strains_are_shares_of_each_bound() -> None:
    rows = JointPoints(np.zeros((1, 1)), np.array([[-1.0]]), np.array([[2.0]]))
    used = utilisation_of_rows(rows, np.array([[-4.0]]), BOUNDS, 0.1).used
    assert used[:, 0] == pytest.approx([0.5, 0.5, 0.2, 0.8])


def test_the_joint_that_uses_most_counts() -> None:
    rows = JointPoints(np.zeros((1, 2)), np.array([[1.0, -3.0]]), np.array([[-2.0, 1.0]]))
    bounds = JointBounds(np.full(2, 2.0), np.full(2, 4.0), np.full(2, 100.0))
    assert utilisation_of_rows(rows, None, bounds, 0.1).used[:, 0] == pytest.approx([1.5, 0.5, 0.2, 0.0])


def going(d1: Array, d2: Array, rates: Array, changes: Array, still: Array) -> Going:
    """Return how a path of one joint is gone, with a tick in each second and a place at each."""
    times = np.arange(float(len(d1)))
    course = np.stack((times, rates, changes))
    points = JointPoints(np.zeros((len(d1), 1)), d1[:, None], d2[:, None])
    return Going(points, no_path_motion(len(d1)), course, times, still)


def test_jerk_of_the_path_is_a_lack_of_rate_and_that_of_the_course_one_of_width() -> None:
    """The second half of the motion is a step of acceleration, once in the path, once in its course."""
    steady, step, nothing = np.ones(4), np.array([0.0, 0.0, 20.0, 20.0]), np.zeros(4)
    rows = JointPoints(np.zeros((4, 1)), np.zeros((4, 1)), 0.1 * step[:, None])  # jerk is 2 of 1
    bounds = JointBounds(np.array([9.0]), np.array([9.0]), np.array([1.0]))
    none = np.empty((4, 0))
    of_path = utilisation_of_rows(rows, None, bounds, 1.0, going(steady, step, steady, nothing, none)).lacks
    assert of_path[0] == pytest.approx(np.log(2.0) / 3.0 * np.array([0.0, 0.0, 1.0, 1.0]))
    assert not of_path[1:].any()
    of_course = utilisation_of_rows(rows, None, bounds, 1.0, going(steady, nothing, steady, step, none)).lacks
    assert of_course[2] == pytest.approx(np.log(2.0) * np.array([0.0, 0.0, 1.0, 1.0]))
    assert of_course[1] == pytest.approx(0.2 * of_course[2])
    assert not of_course[[0, 3]].any()


def test_of_a_torque_that_is_too_much_only_what_gravity_leaves_can_be_given_up() -> None:
    rows = JointPoints(*np.zeros((3, 3, 1)))
    still = np.array([[4.0], [3.0], [2.0]])
    ones, nothing = np.ones(3), np.zeros(3)
    held = going(ones, nothing, ones, nothing, still)
    found = utilisation_of_rows(rows, np.array([[0.0], [6.0], [0.0]]), BOUNDS, 1.0, held, 0.1)
    assert found.peaks == pytest.approx([0.0, 0.0, 0.0, (6.0 - 3.0) / (5.0 - 3.0)])
    assert found.lacks[3] == pytest.approx([0.0, np.log(1.5) + 0.1, np.log(1.5) + 0.1])
    assert not found.is_within_limits


def test_a_steady_jerk_needs_the_cube_root_of_what_it_is_too_much() -> None:
    """Q'' rises by 8 in each second, and 1 is allowed: at half the rate jerk is an eighth."""
    places = np.arange(1.0, 6.0)
    points = JointPoints(*(8.0 * column[:, None] for column in (places**3 / 6.0, places**2 / 2.0, places)))
    bounds = JointBounds(np.array([1e9]), np.array([1e9]), np.array([1.0]))
    assert rates_needed(constraint_rows(points, bounds, None), places, 1e-6) == pytest.approx(np.full(5, 0.5))


def test_places_are_close_where_the_speed_that_a_joint_allows_changes_steeply() -> None:
    """From a crawl to a rush and back; with places 0.1 s apart alone it would change by half at once."""

    class Rush:
        duration = 2.0

        def at(self, phi: Array) -> JointPoints:
            d1 = np.exp(-(((phi - 1.0) / 0.1) ** 2))[:, None] * 50.0
            return JointPoints(np.zeros((len(phi), 1)), d1, np.zeros((len(phi), 1)))

        def path_motion(self, phi: Array) -> PathMotion:
            return no_path_motion(len(phi))

    bounds = JointBounds(np.ones(1), np.ones(1), np.ones(1))
    places, points = grid_points_of(Rush(), bounds, 0.1, np.array([0.0, 2.0]), np.ones(2))
    allowed = 1.0 / np.maximum(np.abs(points.d1[:, 0]), 1.0)
    assert np.abs(np.diff(np.log(allowed))).max() < 0.5
    assert len(places) < 200


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_strains_that_are_no_numbers_are_told_with_their_tick(wrong: float) -> None:
    rows = JointPoints(np.zeros((3, 1)), np.zeros((3, 1)), np.array([[0.0], [wrong], [0.0]]))
    with pytest.raises(ProfileError, match="at tick 1, allowed are finite numbers"):
        utilisation_of_rows(rows, None, BOUNDS, 1.0)


def turning(q: Array, qd: Array, qdd: Array) -> Array:
    """Return torques of inertia, gravity and products of speeds, which all but one go by the rate squared."""
    return np.asarray(2.0 * qdd + np.sin(q) + 0.3 * qd**2)


def test_at_the_rate_that_is_needed_speed_acceleration_and_torque_are_on_their_bounds() -> None:
    motion = Waves(np.random.default_rng(1), 1, 2.0, 1.0, 1.0)
    places, endless = np.linspace(0.3, 1.7, 50), np.full(1, np.inf)
    points = motion.at(places)
    by_speed = constraint_rows(points, JointBounds(BOUNDS.speed, endless, endless), None)
    by_acceleration = constraint_rows(points, JointBounds(endless, BOUNDS.acceleration, endless), None)
    by_torque = constraint_rows(points, JointBounds(endless, endless, endless, BOUNDS.effort), turning)
    w, v, u = (
        np.array([binding_constraint(asked, places, 1e-3, k, k + 1).rate for k in range(50)])[:, None]
        for asked in (by_speed, by_acceleration, by_torque)
    )
    assert np.abs(points.d1) * w == pytest.approx(np.full((50, 1), 2.0))
    assert np.abs(points.d2) * v**2 == pytest.approx(np.full((50, 1), 4.0))
    torque = turning(points.q, points.d1 * u, points.d2 * u**2)
    assert np.abs(torque) == pytest.approx(np.full((50, 1), 5.0), rel=1e-2)  # creeping counts as standing


@pytest.mark.parametrize("seed", range(20))
def test_the_neediest_limit_is_that_of_a_search(seed: int) -> None:
    random = np.random.default_rng(seed)
    m, n, period = 12, 3, 10.0 ** random.uniform(-4.0, -1.0)
    points = JointPoints(*random.normal(size=(3, m, n)))
    places = np.cumsum(10.0 ** random.uniform(-4.0, -1.0, m))
    speed, acceleration, jerk = 10.0 ** random.uniform(-1.0, 1.0, (3, n))
    bounds = JointBounds(speed, acceleration, jerk, random.uniform(1.5, 3.0, n))
    asked = constraint_rows(points, bounds, turning)
    steps = np.abs(np.diff(points.d2, axis=0))
    lasting = np.cbrt(bounds.jerk * np.diff(places)[:, None] / steps)
    between = np.maximum(lasting, np.sqrt(bounds.jerk * period / steps))
    ends = np.full((1, n), np.inf)
    moved = turning(points.q, points.d1, points.d2) - asked.still
    assert bounds.effort is not None
    rates = np.array([
        bounds.speed / np.abs(points.d1),
        np.sqrt(bounds.acceleration / np.abs(points.d2)),
        np.minimum(np.vstack((between, ends)), np.vstack((ends, between))),
        np.sqrt((bounds.effort - np.sign(moved) * asked.still) / np.abs(moved)),
    ])  # fmt: skip
    for begin, end in ((0, m), (3, 7), (0, 1), (m - 1, m)):
        need = binding_constraint(asked, places, period, begin, end)
        among = rates[:, begin:end]
        kind, place, joint = map(int, np.unravel_index(int(np.argmin(among)), among.shape))
        assert need.rate == pytest.approx(among.min(), rel=1e-12)
        assert (need.quantity, need.joint) == (tuple(Quantity)[kind], joint)
        beside = range(begin + place, begin + place + 2)  # a jerk is of two places
        assert need.point in (beside if need.quantity is Quantity.JERK else beside[:1])
    by_speed_and_jerk = np.minimum(rates[::2].min(axis=(0, 2)), 1.0)
    assert rates_needed(asked, places, period) == pytest.approx(by_speed_and_jerk, rel=1e-12)


def test_places_are_dense_where_a_joint_goes_far_within_less_than_a_tick() -> None:
    motion = Passing(3.0, 1e-4)
    bounds = JointBounds(np.array([2.0, 3.0]), np.array([10.0, 30.0]), np.array([100.0, 300.0]))
    places, points = grid_points_of(motion, bounds, 4e-3, np.array([0.0, 3.0]), np.ones(2))
    way = np.abs(np.diff(points.q, axis=0))
    assert (motion.at(places).q == points.q).all()
    assert (way <= 1.5 * 4e-3 * bounds.speed * (1.0 + 1e-9)).all()
    assert len(places) < 5000


def test_a_torque_below_minus_the_bound_is_told_by_its_size() -> None:
    motion = Passing(3.0, 0.5)
    bounds = JointBounds(np.full(2, 0.1), np.full(2, 9.0), np.full(2, 99.0), np.full(2, 5.0))
    found = retime(motion, bounds, lambda q, _qd, qdd: qdd - 6.0 + 0.0 * q, 1e-3)
    assert isinstance(found, Infeasible)
    assert (found.joint, found.value, found.limit) == (0, 6.0, 5.0)


def test_a_joint_that_turns_back_against_dry_friction_does_not_stand_behind_the_turn() -> None:
    """The torque of creeping jumps from +0.8 to -0.8 of 1 N m where joint 1 turns; joint 2 goes on."""
    s = np.linspace(0.0, 3.0, 301)
    points = JointPoints(
        np.column_stack((np.sin(s), s)),
        np.column_stack((np.cos(s), np.ones(301))),
        np.column_stack((-np.sin(s), np.zeros(301))),
    )
    bounds = JointBounds(np.full(2, 5.0), np.full(2, 50.0), np.full(2, np.inf), np.array([1.0, 50.0]))

    def effort(_q: Array, qd: Array, qdd: Array) -> Array:
        return np.asarray(qdd + 0.8 * np.tanh(qd / 5e-3))

    speeds = time_optimal(points, s[1], bounds, effort)
    assert not isinstance(speeds, Infeasible)
    assert speeds[10:-10].min() > 0.05


def test_demand_is_exact_at_the_speed_that_it_is_asked_for() -> None:
    """One pass at the speeds that come out: no row is exceeded, and one of them is met."""
    random = np.random.default_rng(3)
    effort = body(random, 3)
    s = np.linspace(0.0, 1.0, 201)
    path = Waves(random, 3, 1.0, 0.5, 1.0).at(s)
    bounds = JointBounds(np.full(3, 50.0), np.full(3, 1e3), np.full(3, np.inf), np.full(3, 25.0))
    speeds = time_optimal(path, s[1], bounds, effort)
    assert not isinstance(speeds, Infeasible)
    along = np.diff(speeds**2) / (2.0 * s[1])
    qd = path.d1[:-1] * speeds[:-1, None]
    qdd = path.d2[:-1] * speeds[:-1, None] ** 2 + path.d1[:-1] * along[:, None]
    used = np.abs(effort(path.q[:-1], qd, qdd)) / 25.0
    assert used[5:-5].max() <= 1.0 + 2e-2
    assert np.median(used[5:-5].max(axis=1)) >= 1.0 - 2e-2


def on_its_bounds(factor: float) -> tuple[JointPoints, JointBounds]:
    """Return a motion whose joints are at their bounds of acceleration all along, times a factor."""
    accelerations = np.random.default_rng(5).uniform(0.1, 9.0, 6)
    d1 = np.random.default_rng(6).uniform(-1.0, 1.0, (200, 6))
    d2 = np.where(d1 > 0.0, factor, -factor) * accelerations
    return JointPoints(np.zeros((200, 6)), d1, d2), JointBounds(
        np.full(6, 1e9), accelerations, np.full(6, 1e9)
    )


def test_a_motion_that_is_on_its_bounds_goes_on_at_its_own_rate_bit_by_bit() -> None:
    points, bounds = on_its_bounds(1.0 + 4e-10)
    ones = np.ones(200)
    x = Speeds(constraint_rows(points, bounds, None), np.full(199, 1e-3)).under(ones, ones, ones, ones)
    assert (x == 1.0).all()


def test_a_motion_that_is_beyond_its_bounds_is_slowed_to_them_but_for_rounding() -> None:
    points, bounds = on_its_bounds(2.0)
    ones = np.ones(200)
    x = Speeds(constraint_rows(points, bounds, None), np.full(199, 1e-3)).under(ones, ones, ones, ones)[
        :, None
    ]
    u = np.diff(x, axis=0) / 2e-3
    for ends in (slice(None, -1), slice(1, None)):
        asked = np.abs(points.d1[ends] * u + points.d2[ends] * x[ends])
        assert (asked / bounds.acceleration).max() == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize(("ticks", "n"), [(1, 6), (2, 1), (17, 3), (18, 6), (50, 3), (53, 9)])
def test_what_a_plan_uses_is_what_it_uses_gone_at_its_own_rate(ticks: int, n: int) -> None:
    random = np.random.default_rng(7)
    rows, torque = JointPoints(*random.normal(size=(3, ticks, n))), random.normal(size=(ticks, n))
    rows.d2[-1] *= 9.0  # the joints rest behind it
    bounds = JointBounds(*random.uniform(0.5, 2.0, (4, n)))
    whole = utilisation_of_rows(rows, torque, bounds, 0.01)
    plain = utilisation_as_planned(rows, bounds, 0.01)
    assert plain.used[:3] == pytest.approx(whole.used[:3], rel=1e-15)
    assert not plain.used[3].any()
    assert (plain.peaks == plain.used.max(axis=1)).all()
    loaded = with_torque(plain, rows, torque, bounds)
    assert loaded.used == pytest.approx(whole.used, rel=1e-15)
    assert loaded.peaks == pytest.approx(whole.peaks, rel=1e-15)
    assert loaded.factor == pytest.approx(whole.factor, rel=1e-15)


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_a_plan_that_is_no_numbers_is_told_with_its_tick(wrong: float) -> None:
    rows = JointPoints(*np.zeros((3, 5, 1)))
    rows.d2[3] = wrong
    with pytest.raises(ProfileError, match="at tick 3"):
        utilisation_as_planned(rows, BOUNDS, 1.0)
