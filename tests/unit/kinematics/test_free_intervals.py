"""Where the free coordinate of a redundant arm may be: intervals bounded by limits and reach."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim.kinematics import (
    FreeInterval,
    IkOptions,
    IkStatus,
    Limits,
    NotFiniteError,
    chain_arrays,
    forward,
    forward_batch,
    free_intervals,
    inverse,
    redundant_solver_of,
    turning_axes,
)
from ropsim.kinematics.testing import arcs_of, narrow_limits, polished
from ropsim.model import RobotModel, on_track
from ropsim.robots import linear_track, load
from ropsim.spatial import Array, Pose
from support.published_arms import published_arm, random_joints
from support.redundant_poses import narrowed

ARMS = {
    "iiwa14": load("iiwa14"),
    "panda": load("panda"),
    "narrow iiwa14": narrowed(load("iiwa14"), 3),
    "sia20": published_arm("motoman_sia20d"),
    "snapped": published_arm("elephant_myarm_300"),
    "gen3": published_arm("kinova_gen3"),
}
TRIED = 60
BESIDE = 1e-5  # rad
REACHED = 1e-9  # m, entries of the rotation matrix: what is promised


def contains(intervals: tuple[FreeInterval, ...], value: float, margin: float = 0.0) -> bool:
    """Return whether an angle is in one of the intervals, which are wider by a margin [rad]."""
    low = np.array([one.lower for one in intervals]) - margin
    high = np.array([one.upper for one in intervals]) + margin
    return bool(((value + 2.0 * pi * np.ceil((low - value) / (2.0 * pi))) <= high).any())


def answered(robot: RobotModel, pose: Pose, value: float) -> bool:
    return inverse(robot, pose, IkOptions(free=value)).status is IkStatus.FOUND


@pytest.mark.parametrize("name", ARMS)
def test_a_value_has_an_answer_within_the_limits_exactly_where_it_is_in_an_interval(name: str) -> None:
    robot = ARMS[name]
    for q in random_joints(robot, 2, seed=1):
        pose = forward(robot, q)
        found = free_intervals(robot, pose)
        for value in np.linspace(-pi, pi, TRIED, endpoint=False):
            assert answered(robot, pose, float(value)) == contains(found, float(value))


@pytest.mark.parametrize("name", ARMS)
def test_the_ends_are_where_answers_end(name: str) -> None:
    robot, whole = ARMS[name], 2.0 * pi - 2.0 * BESIDE
    for q in random_joints(robot, 2, seed=2):
        pose = forward(robot, q)
        found = free_intervals(robot, pose)
        solver = redundant_solver_of(robot)
        assert solver is not None
        assert contains(found, solver.free(q).value, REACHED)
        for one in found:
            assert -pi < one.lower <= pi
            if one.upper - one.lower > whole:
                continue
            assert answered(robot, pose, one.lower + min(BESIDE, 0.5 * (one.upper - one.lower)))
            for end in (one.lower - BESIDE, one.upper + BESIDE):
                assert not answered(robot, pose, end)


def self_motion(robot: RobotModel, q: Array) -> Array:
    """Return the joint coordinates through which an arm moves without moving its interface, (s, n)."""
    free = np.array([np.full(robot.n, -np.inf), np.full(robot.n, np.inf)])
    return arcs_of(chain_arrays(robot), forward(robot, q).matrix(), q[np.newaxis], free, -1)[0]


@pytest.mark.parametrize("name", ["iiwa14", "panda"])
def test_without_limits_an_arm_moves_along_closed_curves_and_keeps_its_pose(name: str) -> None:
    robot = ARMS[name]
    for q in random_joints(robot, 5, seed=3):
        curve = self_motion(robot, q)
        steps = np.abs(np.diff(curve, axis=0)).max(axis=1)
        assert steps.max() < 0.16
        turns = (curve[-1] - curve[0]) / (2.0 * pi)
        np.testing.assert_allclose(turns, np.round(turns), atol=REACHED)
        reached = forward_batch(robot, curve)
        np.testing.assert_allclose(reached, [forward(robot, q).matrix()] * len(curve), rtol=0.0, atol=REACHED)


@pytest.mark.parametrize("name", ["iiwa14", "panda"])
def test_a_pose_that_is_reached_in_one_point_only_is_found(name: str) -> None:
    """A joint is given a limit where it turns back: refined by halving between points of the curve."""
    wide = ARMS[name]
    joints = tuple(replace(one, lower=-10.0, upper=10.0) for one in wide.joints)
    robot = replace(wide, joints=joints)
    (q,) = random_joints(wide, 1, seed=7)
    curve = self_motion(robot, q)
    joint = 1
    top = int(np.argmax(curve[:, joint]))
    around = curve[[top - 1, top, (top + 1) % len(curve)]]
    shares = np.linspace(-1.0, 1.0, 2001)
    fine = np.array([around[1] + abs(s) * (around[0 if s < 0.0 else 2] - around[1]) for s in shares])
    own = chain_arrays(robot)
    kept = polished(own, forward(robot, q).matrix()[np.newaxis], fine[np.newaxis])[0]
    highest = float(kept[:, joint].max())
    limits = replace(robot.joints[joint], lower=highest, upper=highest + 0.5)
    touched = replace(robot, joints=(*joints[:joint], limits, *joints[joint + 1 :]))
    found = inverse(touched, forward(robot, q))
    assert found.status is IkStatus.FOUND
    assert any(one.upper - one.lower < 0.02 for one in free_intervals(touched, forward(robot, q)))


def test_arms_with_nothing_free_have_no_intervals() -> None:
    robot = load("puma560")
    assert free_intervals(robot, forward(robot, robot.home)) == ()


def test_a_pose_out_of_reach_has_no_intervals() -> None:
    for name in ("iiwa14", "panda"):
        assert free_intervals(ARMS[name], Pose(np.array([2.0, 0.0, 0.4]))) == ()


def test_external_axes_stay_where_near_has_them() -> None:
    arm = ARMS["iiwa14"]
    robot = on_track(replace(arm, drives=()), linear_track(4.0))
    q = np.array([*random_joints(arm, 1, seed=5)[0], 0.7])
    expected = free_intervals(arm, forward(arm, q[:-1]))
    found = free_intervals(robot, forward(robot, q), q)
    ends = [(one.lower, one.upper) for one in found]
    np.testing.assert_allclose(ends, [(one.lower, one.upper) for one in expected], atol=1e-7)


def test_a_pose_that_is_none_is_refused() -> None:
    with pytest.raises(NotFiniteError):
        free_intervals(ARMS["iiwa14"], Pose(np.array([np.nan, 0.0, 0.0])))


@pytest.mark.parametrize("name", ["iiwa14", "panda"])
def test_no_interval_is_searched_where_the_present_value_has_an_answer(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ropsim.kinematics.solutions.redundancy.reachable", None)
    robot = ARMS[name]
    for q in random_joints(robot, 5, seed=8):
        assert inverse(robot, forward(robot, q), IkOptions(near=q)).status is IkStatus.FOUND


@pytest.mark.parametrize("name", ["narrow iiwa14", "panda"])
def test_the_nearest_value_of_all_is_taken(name: str) -> None:
    robot, moved = ARMS[name], 0
    solver = redundant_solver_of(robot)
    assert solver is not None
    pairs = zip(random_joints(robot, 16, seed=9), random_joints(robot, 16, seed=10), strict=True)
    for q, near in pairs:
        pose, here = forward(robot, q), solver.free(near).value
        if answered(robot, pose, here):
            continue
        moved += 1
        ends = np.array([end for one in free_intervals(robot, pose) for end in (one.lower, one.upper)])
        least = np.abs((ends - here + pi) % (2.0 * pi) - pi).min()
        found = inverse(robot, pose, IkOptions(near=near))
        assert found.free is not None
        assert abs((found.free.value - here + pi) % (2.0 * pi) - pi) == pytest.approx(least, abs=REACHED)
    assert moved >= 2


def test_limits_that_are_ignored_bound_no_interval() -> None:
    robot = narrowed(ARMS["panda"], 4)
    q = random_joints(ARMS["panda"], 1, seed=10)[0]
    assert inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE)).status is IkStatus.FOUND


def test_joints_with_a_whole_turn_between_their_limits_have_none() -> None:
    robot = ARMS["gen3"]
    limits = np.stack((robot.lower_limits, robot.upper_limits, turning_axes(robot)))
    assert np.isinf(narrow_limits(limits)).all(axis=0).tolist() == [i % 2 == 0 for i in range(7)]


@pytest.mark.parametrize(
    "q",
    [
        (1.75034, 1.92335, 0.12011, 0.001, 0.05867, 1.37934, 1.50727),
        (0.14994, 2.00198, 0.13227, -0.0001, -2.52322, 0.40025, 1.42136),
    ],
)
def test_the_intervals_of_an_almost_stretched_arm_are_whole(q: tuple[float, ...]) -> None:
    """The curves of the elbow forth and back are next to each other, and are not followed into each other."""
    robot = ARMS["iiwa14"]
    pose = forward(robot, q)
    found = free_intervals(robot, pose)
    for value in np.linspace(-pi, pi, TRIED, endpoint=False):
        assert answered(robot, pose, float(value)) == contains(found, float(value))
