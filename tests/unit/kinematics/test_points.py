"""Points of arms with few axes: answers against a search of scipy, and derivatives along paths."""

import numpy as np
import pytest
from scipy.optimize import least_squares

from ropsim import robots
from ropsim.kinematics import (
    Places,
    chooses_points_only,
    followed_points,
    point_answers,
    points_continued,
    points_near,
    spare_joints,
    turning_axes,
)
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.few_axes import ARMS, DETERMINED, TOOL, drawn, places, two_link

EXACT = 1e-12
"""Rounding of forward kinematics of arms of a metre [m]."""
SAME = 1e-6
"""Joint coordinates of one answer [rad | m]."""
SEARCHED = 1e-7
"""How well a search of least squares finds a distance [m]."""


def searched(robot: RobotModel, point: Array, start: Array) -> tuple[Array, float]:
    """Return where scipy's search from a start ends, and its distance from a point [m]."""
    tight = {"xtol": 1e-13, "ftol": 1e-13, "gtol": 1e-13, "max_nfev": 60}
    found = least_squares(lambda q: places(robot, q)[0] - point, start, **tight)
    return np.asarray(found.x), float(np.linalg.norm(found.fun))


def straight(robot: RobotModel, q: Array, q_end: Array, rows: int = 81) -> tuple[Array, Array, Array]:
    """Return path parameters, points and derivatives of the line between the TCPs of two configurations."""
    begin, end = places(robot, q)[0], places(robot, q_end)[0]
    length = float(np.linalg.norm(end - begin))
    s = np.linspace(0.0, length, rows)
    tool = np.zeros((2, rows, 6))
    tool[0, :, :3] = (end - begin) / length
    return s, begin + np.outer(s / length, end - begin), tool


@pytest.mark.parametrize("name", ARMS)
def test_every_answer_reaches_its_point(name: str) -> None:
    robot, rng = ARMS[name], np.random.default_rng(1)
    for _ in range(20):
        point, near = places(robot, drawn(robot, rng))[0], drawn(robot, rng)
        answers = point_answers(robot, TOOL, point, near)
        assert len(answers.branches)
        assert answers.miss == 0.0
        assert np.abs(places(robot, answers.branches) - point).max() <= EXACT


@pytest.mark.parametrize("name", DETERMINED)
def test_all_answers_that_scipy_finds_are_among_them(name: str) -> None:
    robot, rng = ARMS[name], np.random.default_rng(2)
    turns = 2.0 * np.pi * turning_axes(robot)
    for _ in range(6):
        q = drawn(robot, rng)
        point = places(robot, q)[0]
        branches = point_answers(robot, TOOL, point, drawn(robot, rng)).branches
        for start in (q, *(drawn(robot, rng) for _ in range(6))):
            found, away = searched(robot, point, start)
            if away < EXACT:
                apart = branches - found
                apart -= turns * np.round(apart / np.where(turns > 0.0, turns, 1.0))
                assert np.abs(apart).max(axis=1).min() < SAME


@pytest.mark.parametrize("name", [one for one in ARMS if one not in DETERMINED])
def test_with_joints_to_spare_no_answer_of_scipy_is_nearer(name: str) -> None:
    """The nearest one in shares of the greatest speeds, among those next to it."""
    robot, rng = ARMS[name], np.random.default_rng(3)
    scale = robot.max_speeds / robot.max_speeds.max()
    assert spare_joints(robot, TOOL) == robot.n - (2 if name == "planar 3R" else 3)
    for _ in range(4):
        near = drawn(robot, rng)
        point = places(robot, near + 0.1 * rng.normal(size=robot.n) * scale)[0]
        branches = point_answers(robot, TOOL, point, near).branches
        best = np.linalg.norm((branches - near) / scale, axis=1).min()

        def cost(q: Array, near: Array = near, point: Array = point) -> Array:
            return np.concatenate((1e-4 * (q - near) / scale, places(robot, q)[0] - point))

        other = np.asarray(least_squares(cost, near, xtol=1e-15, ftol=1e-15, gtol=1e-15).x)
        assert best <= np.linalg.norm((other - near) / scale) + 1e-3


@pytest.mark.parametrize("name", ARMS)
def test_a_point_that_is_missed_states_its_true_distance(name: str) -> None:
    robot, rng = ARMS[name], np.random.default_rng(4)
    for _ in range(3):
        q = drawn(robot, rng)
        point = places(robot, q)[0] + rng.normal(size=3) * 6.0
        answers = point_answers(robot, TOOL, point, q)
        if len(answers.branches):  # slides have no limits here
            continue
        best = min(searched(robot, point, drawn(robot, rng))[1] for _ in range(10))
        assert abs(answers.miss - best) < SEARCHED


@pytest.mark.parametrize("name", ARMS)
def test_a_point_that_stands_is_reached_without_a_motion(name: str) -> None:
    robot = ARMS[name]
    q = drawn(robot, np.random.default_rng(5))
    branches = point_answers(robot, TOOL, places(robot, q)[0], q).branches
    assert np.abs(branches - q).max(axis=1).min() < SAME


@pytest.mark.parametrize("aside", [-0.2, 3.2e-3, 2e-5])
def test_the_plane_of_an_arm_is_known_and_how_far_a_point_is_beside_it(aside: float) -> None:
    robot = two_link()
    q = np.array([0.7, -1.2])
    point = places(robot, q)[0] + np.array([0.0, aside, 0.0])
    answers = point_answers(robot, TOOL, point, q)
    assert answers.places is Places.PLANE
    assert not len(answers.branches)
    assert answers.beside == pytest.approx(abs(aside), abs=1e-12)
    assert answers.miss == pytest.approx(abs(aside), abs=1e-12)


def test_rounding_beside_the_plane_is_no_miss() -> None:
    robot, q = two_link(), np.array([0.7, -1.2])
    assert len(point_answers(robot, TOOL, places(robot, q)[0] + np.array([0.0, 5e-6, 0.0]), q).branches) == 2


@pytest.mark.parametrize(
    ("types", "kind"),
    [
        ("P", Places.LINE),
        ("R", Places.CURVE),
        ("PP", Places.PLANE),
        ("RR", Places.SURFACE),
        ("PR", Places.SURFACE),
        ("RRR", Places.SPACE),
        ("PPP", Places.SPACE),
    ],
)
def test_where_the_tcp_can_be_is_named(types: str, kind: Places) -> None:
    robot = random_arm(3, types)
    q = np.zeros(robot.n)
    answers = point_answers(robot, TOOL, places(robot, q)[0], q)
    assert answers.places is kind
    assert len(answers.branches)


@pytest.mark.parametrize("name", ARMS)
def test_rows_on_a_line_are_on_it_and_have_their_derivatives(name: str) -> None:
    robot, rng, count = ARMS[name], np.random.default_rng(6), 0
    for _ in range(12):
        q = drawn(robot, rng)
        s, points, tool = straight(robot, q, q + 0.2 * rng.normal(size=robot.n))
        made = followed_points(robot, s, points, q, TOOL, tool)
        if made is None:
            continue
        Q, (d1, d2) = made
        count += 1
        assert np.abs(places(robot, Q) - points).max() <= EXACT
        h = s[1] - s[0]
        size = 1.0 + np.abs(d1).max() + np.abs(d2).max()
        both = Q[1:] - Q[:-1] - 0.5 * h * (d1[1:] + d1[:-1]) - h * h / 12.0 * (d2[:-1] - d2[1:])
        change = d1[1:] - d1[:-1] - 0.5 * h * (d2[1:] + d2[:-1])
        assert np.median(np.abs(both)) < 1e-7 * size
        assert np.median(np.abs(change)) < 1e-4 * size
        J = (places(robot, Q[40] + 1e-6 * d1[40]) - places(robot, Q[40] - 1e-6 * d1[40])) / 2e-6
        assert np.abs(J[0] - tool[0, 40, :3]).max() < 1e-6
    assert count >= 6


@pytest.mark.parametrize("name", [one for one in ARMS if one not in DETERMINED])
def test_joint_rates_with_joints_to_spare_are_the_least_ones(name: str) -> None:
    robot, rng = ARMS[name], np.random.default_rng(7)
    scale = robot.max_speeds / robot.max_speeds.max()
    q = drawn(robot, rng)
    s, points, tool = straight(robot, q, q + 0.1 * rng.normal(size=robot.n))
    made = followed_points(robot, s, points, q, TOOL, tool)
    assert made is not None
    h = 1e-6
    for row in (0, 40, 80):
        at, rates = made[0][row], made[1][0, row] / scale
        J = (
            np.array(
                [
                    (places(robot, at + h * one) - places(robot, at - h * one))[0] / (2.0 * h)
                    for one in np.eye(robot.n)
                ]
            ).T
            * scale
        )
        least = np.linalg.pinv(J, rcond=1e-6) @ (J @ rates)
        assert np.abs(least - rates).max() < 1e-5 * (1.0 + np.abs(rates).max())


@pytest.mark.parametrize("name", [one for one in ARMS if one not in DETERMINED])
def test_next_to_a_limit_derivatives_are_those_of_the_coordinates(name: str) -> None:
    """Where a joint gives way to the others: value and first derivative of each step by the next two."""
    robot, rng = ARMS[name], np.random.default_rng(8)
    q = drawn(robot, rng)
    q[1] = robot.upper_limits[1] - 0.02 * (robot.upper_limits[1] - robot.lower_limits[1])
    s, points, tool = straight(robot, q, q + 0.05 * rng.normal(size=robot.n), 801)
    made = followed_points(robot, s, points, q, TOOL, tool)
    assert made is not None
    Q, (d1, d2) = made
    h, size = s[1] - s[0], 1.0 + np.abs(d1).max() + np.abs(d2).max()
    both = Q[1:] - Q[:-1] - 0.5 * h * (d1[1:] + d1[:-1]) - h * h / 12.0 * (d2[:-1] - d2[1:])
    change = d1[1:] - d1[:-1] - 0.5 * h * (d2[1:] + d2[:-1])
    assert np.abs(both).max() < 1e-10 * size
    assert np.abs(change).max() < 1e-6 * size


def test_a_joint_that_others_can_replace_stays_off_its_limit() -> None:
    """Away from its limit the second of three joints would turn on by 12°, here it has 3° left."""
    robot = ARMS["planar 3R"]
    q = np.array([0.4, robot.upper_limits[1] - np.radians(3.0), -0.8])
    q_end = q + np.array([-0.05, np.radians(12.0), 0.1])
    s, points, tool = straight(robot, q, q_end)
    made = followed_points(robot, s, points, q, TOOL, tool)
    assert made is not None
    assert made[0][:, 1].max() < robot.upper_limits[1]
    away = q - np.array([0.0, 1.0, 0.0])
    s, points, tool = straight(robot, away, away + (q_end - q))
    other = followed_points(robot, s, points, away, TOOL, tool)
    assert other is not None
    assert np.ptp(other[0][:, 1]) > np.radians(3.0)


def test_rows_beyond_the_reach_are_none_and_those_before_are_reached() -> None:
    robot = two_link()
    q = np.array([0.3, -0.4])
    begin = places(robot, q)[0]
    out = begin - np.array([0.0, 0.0, 1.0])
    points = begin + np.outer(np.linspace(0.0, 1.0, 101), out / np.linalg.norm(out))
    Q = points_continued(robot, TOOL, points, q, q)
    lost = np.flatnonzero(np.isnan(Q[:, 0]))
    assert 0 < lost[0] < 100
    assert np.isnan(Q[lost[0] :]).all()
    assert np.abs(places(robot, Q[: lost[0]]) - points[: lost[0]]).max() <= EXACT


def test_an_arm_with_six_axes_chooses_whole_poses() -> None:
    assert not chooses_points_only(robots.load("puma560"))
    assert chooses_points_only(two_link())


def test_a_guess_leads_to_the_answer_next_to_it() -> None:
    robot, q = two_link(), np.array([0.7, -1.2])
    (found,) = points_near(robot, TOOL, places(robot, q), (q + 0.02)[np.newaxis])
    assert np.abs(found - q).max() < SAME
    (none,) = points_near(robot, TOOL, places(robot, q) * 9.0, q[np.newaxis])
    assert np.isnan(none).all()


def test_a_joint_that_moves_the_tcp_nowhere_reaches_one_place() -> None:
    robot = random_arm(3, "R")
    q = np.zeros(1)
    X_MJ = robot.interface.inverse()  # a TCP on the axis
    answers = point_answers(robot, X_MJ, _place(robot, X_MJ, q), q)
    assert answers.places is Places.POINT
    assert len(answers.branches) == 1
    far = point_answers(robot, X_MJ, _place(robot, X_MJ, q) + np.array([0.03, 0.0, 0.04]), q)
    assert far.miss == pytest.approx(0.05)


def _place(robot: RobotModel, X_MT: Pose, q: Array) -> Array:
    from ropsim.kinematics import tool_pose

    return tool_pose(robot, q, X_MT).position
