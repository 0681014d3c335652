"""Points of arms with closed chains: a five-bar and a delta, against triangles, circles and scipy."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import minimize

from ropsim.kinematics import (
    Places,
    chooses_points_only,
    followed_points,
    forward,
    forward_batch,
    inverse_batch,
    loop_gaps,
    point_answers,
    points_continued,
    points_near,
    solver_of,
    spare_joints,
)
from ropsim.kinematics.testing import numeric
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.closed_arms import (
    ASIDE,
    BARS,
    BASE,
    LOWER,
    R_BASE,
    R_PLATE,
    UPPER,
    delta,
    five_bar,
    five_bar_angles,
    palletizer,
    six_axis_with_cylinders,
)

TOOL = Pose(np.array([0.02, 0.0, 0.05]))
MAKERS = {"five-bar": five_bar, "delta": delta}
EXACT = 1e-12
"""Rounding of closed chains of half a metre [m]."""


def place(robot: RobotModel, q: Array, tool: Pose = TOOL) -> Array:
    return (forward(robot, q) @ tool).position


def delta_angles(x: float, y: float, z: float) -> Array:
    """Return the angles of the bars of the delta, knees outwards, for a place of its plate.

    In the plane of each bar a circle about its axis meets the sphere of the rod (Clavel 1991).
    """
    found = []
    for k in range(3):
        c, s = np.cos(2.0 * np.pi * k / 3.0), np.sin(2.0 * np.pi * k / 3.0)
        out, side = c * x + s * y + R_PLATE - R_BASE, -s * x + c * y
        reach = out * out + z * z + UPPER**2 + side * side - LOWER**2
        found.append(np.arctan2(z, out) + np.arccos(reach / (2.0 * UPPER * np.hypot(out, z))))
    return np.array(found)


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_few_axes_of_closed_chains_choose_points(make: Callable[[], RobotModel]) -> None:
    robot = make()
    assert chooses_points_only(robot)
    assert spare_joints(robot, TOOL) == 0


def test_parallelograms_choose_points_as_couplings_do_and_six_axes_do_not() -> None:
    assert chooses_points_only(palletizer())
    assert not chooses_points_only(six_axis_with_cylinders())


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_configurations_are_among_the_answers_for_their_points(make: Callable[[], RobotModel]) -> None:
    robot = make()
    for q in robot.home + np.random.default_rng(1).uniform(-0.3, 0.3, (3, robot.n)):
        found = point_answers(robot, TOOL, place(robot, q), robot.home)
        assert found.miss == 0.0
        assert np.abs(found.branches - q).max(axis=1).min() < 1e-9
        for branch in found.branches:
            np.testing.assert_allclose(place(robot, branch), place(robot, q), atol=EXACT)


def test_a_five_bar_has_the_angles_of_its_two_triangles_at_a_point() -> None:
    robot = five_bar()
    for x, y in np.random.default_rng(3).uniform((-0.15, 0.45), (0.15, 0.65), (5, 2)):
        found = point_answers(robot, Pose(), np.array([x, y, 0.0]), robot.home)
        assert np.abs(found.branches - five_bar_angles(x, y)).max(axis=1).min() < 1e-9


def test_a_delta_has_the_angles_of_circles_and_spheres_at_a_point() -> None:
    robot = delta()
    home = place(robot, robot.home, Pose())
    for shift in np.random.default_rng(3).uniform(-0.06, 0.06, (5, 3)):
        point = home + shift
        expected = delta_angles(*point)
        expected -= 2.0 * np.pi * np.round(expected / (2.0 * np.pi))
        found = point_answers(robot, Pose(), point, robot.home)
        assert np.abs(found.branches - expected).max(axis=1).min() < 1e-9
    assert ASIDE > 0.0


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_rows_on_a_line_are_on_it_and_have_their_derivatives(make: Callable[[], RobotModel]) -> None:
    robot = make()
    begin = place(robot, robot.home)
    way = np.array([0.05, 0.02, 0.0 if robot.n == 2 else 0.03])
    s = np.linspace(0.0, 1.0, 41)
    points, tool = begin + np.outer(s, way), np.zeros((2, len(s), 6))
    tool[0, :, :3] = way
    found = followed_points(robot, s, points, robot.home, TOOL, tool)
    assert found is not None
    q, (first, second) = found
    along = (forward_batch(robot, q) @ TOOL.matrix())[:, :3, 3]
    np.testing.assert_allclose(along, points, atol=EXACT)
    step = s[1]
    fourth = (q[:-4] - 8.0 * q[1:-3] + 8.0 * q[3:-1] - q[4:]) / (12.0 * step)
    np.testing.assert_allclose(first[2:-2], fourth, atol=1e-6)
    fourth = (first[:-4] - 8.0 * first[1:-3] + 8.0 * first[3:-1] - first[4:]) / (12.0 * step)
    np.testing.assert_allclose(second[2:-2], fourth, atol=1e-6)
    np.testing.assert_allclose(points_continued(robot, TOOL, points, robot.home, robot.home), q, atol=1e-9)
    np.testing.assert_allclose(points_near(robot, TOOL, points[::10], q[::10] + 0.01), q[::10], atol=1e-9)


def test_a_line_out_of_reach_is_followed_as_far_as_it_goes() -> None:
    robot = five_bar()
    points = place(robot, robot.home) + np.linspace(0.0, 0.6, 61)[:, np.newaxis] * [0.0, 1.0, 0.0]
    rows = points_continued(robot, TOOL, points, robot.home, robot.home)
    lost = int(np.flatnonzero(np.isnan(rows[:, 0]))[0])
    assert 10 < lost < 40
    assert np.isnan(rows[lost:]).all()
    found = point_answers(robot, TOOL, points[lost], rows[lost - 1])
    assert not len(found.branches)
    assert 0.0 < found.miss < 0.011


def test_the_distance_of_a_point_out_of_reach_is_that_of_scipy() -> None:
    """The nearest place of a five-bar is where one of its sides is stretched."""
    robot = five_bar()
    goal = np.array([0.75, 0.55, 0.0])
    found = point_answers(robot, Pose(), goal, robot.home)

    def distance(q: Array) -> float:
        closed = float(loop_gaps(robot, q[np.newaxis])[0]) < 1e-9
        return float(np.linalg.norm(place(robot, q, Pose()) - goal)) if closed else 10.0

    starts = robot.home + np.random.default_rng(2).uniform(-0.4, 0.4, (4, 2))
    least = min(minimize(distance, one, method="Nelder-Mead", options={"xatol": 1e-9}).fun for one in starts)
    assert not len(found.branches)
    assert found.miss <= least + 1e-5
    assert found.miss >= np.hypot(goal[0] + BASE / 2.0, goal[1]) - sum(BARS)
    assert found.places is Places.PLANE


def test_a_point_beside_the_plane_is_told_so() -> None:
    robot = five_bar()
    point = place(robot, robot.home, Pose()) + np.array([0.0, 0.0, 0.01])
    found = point_answers(robot, Pose(), point, robot.home)
    assert not len(found.branches)
    assert found.miss == pytest.approx(0.01, abs=1e-9)
    assert found.beside == pytest.approx(0.01, abs=1e-9)


def test_a_delta_is_solved_in_closed_form_with_branches_beside_its_own() -> None:
    robot = delta()
    q = robot.home + np.array([0.1, -0.05, 0.2])
    rows = inverse_batch(robot, forward(robot, q).matrix()[np.newaxis])[0]
    present = rows[~np.isnan(rows[:, 0])]
    assert solver_of(robot).name == "plate on rods"
    assert np.abs(present - q).max(axis=1).min() < 1e-12
    flipped = [(np.abs(one - q) > 0.1).sum() for one in present]
    assert sorted(flipped)[:4] == [0, 1, 1, 1]


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_the_search_in_all_coordinates_finds_the_pose_of_a_configuration(
    make: Callable[[], RobotModel],
) -> None:
    robot = make()
    search = numeric(robot)
    for q in robot.home + np.random.default_rng(4).uniform(-0.3, 0.3, (3, robot.n)):
        found = search.branches(forward(robot, q).matrix()[np.newaxis], robot.home)[0]
        assert np.nanmin(np.abs(found - q).max(axis=1)) < 1e-9
