"""Inverse kinematics of arms with closed chains: against closed forms, the coupled arm, and poses known."""

import numpy as np
import pytest

from ropsim.kinematics import (
    IkOptions,
    Limits,
    Method,
    Nearest,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    inverse_near,
    inverse_path,
    jacobians_at,
    nearest,
    path_derivatives,
    posture,
    solver_of,
)
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.closed_arms import (
    BARS,
    BASE,
    COUPLED_PALLETIZER,
    L1,
    L2,
    delta,
    five_bar,
    five_bar_angles,
    lengths_of,
    palletizer,
    six_axis_with_cylinders,
    two_link_with_cylinders,
)

ARMS = {
    "palletizer": (palletizer, "level wrist"),
    "two-link with cylinders": (two_link_with_cylinders, "planar two-link"),
    "five-bar": (five_bar, "planar two-link"),
    "six-axis with cylinders": (six_axis_with_cylinders, "spherical wrist"),
    "delta": (delta, "plate on rods"),
}
SMALL = {"palletizer": 0.3, "five-bar": 0.25, "delta": 0.3}
SAME = 1e-9


def rows_of(robot: RobotModel, count: int, seed: int = 1) -> Array:
    reach = SMALL.get(robot.name, 0.024)
    return np.asarray(robot.home + np.random.default_rng(seed).uniform(-reach, reach, (count, robot.n)))


@pytest.mark.parametrize("name", ARMS)
def test_an_arm_with_closed_chains_is_in_the_class_of_its_joints(name: str) -> None:
    make, class_ = ARMS[name]
    assert solver_of(make()).name == class_


@pytest.mark.parametrize("name", ARMS)
def test_configurations_are_among_the_answers_for_their_poses(name: str) -> None:
    robot = ARMS[name][0]()
    for q in rows_of(robot, 3 if name == "delta" else 20):
        found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=robot.home))
        present = found.branches[~np.isnan(found.branches[:, 0])]
        assert np.abs(present - q).max(axis=1).min() < 1e-7
        poses = forward_batch(robot, present)
        errors = np.abs(poses - forward(robot, q).matrix()).sum(axis=(1, 2))
        assert errors.max() < solver_of(robot).slack


def test_a_palletizer_with_cut_parallelograms_has_the_answers_of_the_coupled_one() -> None:
    cut = palletizer()
    poses = forward_batch(COUPLED_PALLETIZER, rows_of(COUPLED_PALLETIZER, 30))
    found, expected = inverse_batch(cut, poses), inverse_batch(COUPLED_PALLETIZER, poses)
    np.testing.assert_allclose(found, expected, atol=SAME)
    assert solver_of(cut).postures == solver_of(COUPLED_PALLETIZER).postures


def test_cylinders_of_a_two_link_arm_are_as_long_as_the_law_of_cosines_says() -> None:
    robot = two_link_with_cylinders()
    for shoulder, elbow in ((0.9, -1.3), (1.1, -1.5), (0.7, -1.2)):
        angle = shoulder + elbow
        place = [
            L1 * np.cos(shoulder) + L2 * np.cos(angle),
            L1 * np.sin(shoulder) + L2 * np.sin(angle),
            0.0,
        ]
        pose = Pose(np.array(place), np.array([np.cos(angle / 2.0), 0.0, 0.0, np.sin(angle / 2.0)]))
        found = inverse(robot, pose)
        np.testing.assert_allclose(found.solutions, [lengths_of(shoulder, elbow)], atol=SAME)
        assert str(found.postures[0]) == str(posture(robot, found.solutions[0])) == "up"


def test_a_five_bar_has_the_angles_of_its_two_triangles() -> None:
    """The pose of the left bar, whose turn follows from the place, gives both driven angles."""
    robot = five_bar()
    for x, y in np.random.default_rng(3).uniform((-0.15, 0.45), (0.15, 0.65), (40, 2)):
        left, right = five_bar_angles(x, y)
        knee = np.array([-BASE / 2.0 + BARS[0] * np.cos(left), BARS[0] * np.sin(left)])
        turn = np.arctan2(y - knee[1], x - knee[0])
        pose = Pose(np.array([x, y, 0.0]), np.array([np.cos(turn / 2.0), 0.0, 0.0, np.sin(turn / 2.0)]))
        found = inverse(robot, pose, IkOptions(Limits.IGNORE))
        np.testing.assert_allclose(found.solutions, [[left, right]], atol=SAME)


def test_six_axes_with_cylinders_have_all_branches_whose_cylinders_reach() -> None:
    """Wrist up and down, the elbow on one side: its cylinder cannot swing it over."""
    robot = six_axis_with_cylinders()
    assert solver_of(robot).method is Method.CLOSED_FORM
    for q in rows_of(robot, 5) + np.array([0.3, 0.0, 0.0, 0.2, 0.0, 0.4]):
        found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE))
        names = {str(one) for one in found.postures}
        assert {name.rsplit("-", 1)[1] for name in names} == {"flip", "noflip"}
        assert len(found.solutions) == 2


@pytest.mark.parametrize("name", ARMS)
def test_a_path_is_followed_back_to_its_joints(name: str) -> None:
    robot = ARMS[name][0]()
    ends = rows_of(robot, 2, seed=5)
    rows = ends[0] + np.linspace(0.0, 1.0, 40)[:, np.newaxis] * (ends[1] - ends[0])
    poses = forward_batch(robot, rows)
    np.testing.assert_allclose(inverse_path(robot, poses, rows[0]), rows, atol=1e-7)
    np.testing.assert_allclose(inverse_near(robot, poses, rows + 1e-3), rows, atol=1e-7)


@pytest.mark.parametrize("name", ARMS)
def test_derivatives_of_the_axes_on_a_path_come_back_from_those_of_the_tool(name: str) -> None:
    robot, step = ARMS[name][0](), 1e-5
    X_MT = Pose(np.array([0.1, 0.05, 0.2]), np.array([0.9, 0.1, -0.3, 0.2]))
    random = np.random.default_rng(2)
    for q in rows_of(robot, 4):
        first, second = random.normal(size=(2, robot.n))

        def velocity(s: float, q: Array = q, one: Array = first, two: Array = second) -> Array:
            J = jacobians_at(robot, (q + s * one + 0.5 * s * s * two)[np.newaxis], X_MT)[1]
            return np.asarray(J[0] @ (one + s * two))

        tool = np.stack((velocity(0.0), (velocity(step) - velocity(-step)) / (2.0 * step)))[:, np.newaxis]
        found = path_derivatives(robot, q[np.newaxis], X_MT, tool)
        assert found is not None
        size = 1.0 + np.abs(tool).max()
        np.testing.assert_allclose(found[:, 0], (first, second), atol=1e-6 * size)


def test_a_pose_beyond_the_cylinders_is_refused_with_the_nearest_one() -> None:
    robot = two_link_with_cylinders()
    out = inverse(robot, Pose(np.array([1.6, 0.6, 0.0])))
    assert not len(out.solutions)
    found = nearest(robot, forward(robot, robot.home))
    assert isinstance(found, Nearest)
    assert found.distance < 1e-9


def test_a_pose_that_only_the_locked_assembly_has_is_out_of_reach() -> None:
    """The joints could take it, elbow on the other side; the chains lock on the way there."""
    robot = two_link_with_cylinders()
    shoulder, elbow = 0.4, 1.4
    angle = shoulder + elbow
    place = [L1 * np.cos(shoulder) + L2 * np.cos(angle), L1 * np.sin(shoulder) + L2 * np.sin(angle), 0.0]
    pose = Pose(np.array(place), np.array([np.cos(angle / 2.0), 0.0, 0.0, np.sin(angle / 2.0)]))
    found = inverse(robot, pose)
    assert not len(found.solutions)
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert "lock" in found.shortfall.miss.why
