import subprocess
import sys
from math import pi

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import POSES, forward_rows
from ropsim.spatial import Pose
from support.arms import random_arm
from support.in_python import in_python

ROUNDING = 1e-14
"""A few rounding errors of numbers of the order of 1."""

PUMA = robots.load("puma560")
TWO_LINK = robots.load("two_link")


def test_two_link_arm_points_where_geometry_says() -> None:
    np.testing.assert_allclose(kinematics.forward(TWO_LINK, [0.0, 0.0]).position, [2, 0, 0], atol=ROUNDING)
    np.testing.assert_allclose(kinematics.forward(TWO_LINK, [pi / 2, 0.0]).position, [0, 0, 2], atol=ROUNDING)
    np.testing.assert_allclose(kinematics.forward(TWO_LINK, [0.0, pi / 2]).position, [1, 0, 1], atol=ROUNDING)


@pytest.mark.parametrize("types", ["R", "P", "RPR", "PRRPRRR"])
def test_compiled_and_plain_forward_kinematics_agree(types: str) -> None:
    robot = random_arm(3, types)
    Q = np.random.default_rng(1).uniform(-3.0, 3.0, (20, robot.n))
    frames = kinematics.frames_batch(robot, Q)
    np.testing.assert_allclose(kinematics.forward_batch(robot, Q), frames[:, -1], atol=10 * ROUNDING)
    np.testing.assert_allclose(kinematics.joint_frames(robot, Q[7]), frames[7], atol=ROUNDING)
    np.testing.assert_allclose(kinematics.forward(robot, Q[7]).matrix(), frames[7, -1], atol=10 * ROUNDING)


@pytest.mark.parametrize("name", ["puma560", "palletizer", "stanford"])
def test_the_pose_of_a_tool_is_that_of_the_interface_and_the_tool_to_the_bit(name: str) -> None:
    robot, random = robots.load(name), np.random.default_rng(4)
    tools = [Pose(), *(Pose(random.normal(size=3), random.normal(size=4)) for _ in range(3))]
    for _ in range(50):
        q = random.uniform(-3.0, 3.0, robot.n)
        for X_MT in tools:
            found, X_BM = kinematics.tool_pose(robot, q, X_MT), kinematics.forward_batch(robot, [q])[0]
            assert found.as_tuple() == (Pose.from_matrix(X_BM) @ X_MT).as_tuple()
            assert not found.position.flags.writeable


@pytest.mark.parametrize("name", ["puma560", "palletizer", "stanford"])
def test_places_of_tools_are_those_of_their_poses(name: str) -> None:
    robot, random = robots.load(name), np.random.default_rng(5)
    Q = random.uniform(-3.0, 3.0, (20, robot.n))
    tools = [Pose(random.normal(size=3), random.normal(size=4)) for _ in Q]
    wanted = [(kinematics.forward(robot, q) @ X_MT).position for q, X_MT in zip(Q, tools, strict=True)]
    np.testing.assert_allclose(kinematics.tool_places(robot, Q.ravel(), tools), wanted, atol=ROUNDING)


def test_the_kernel_does_the_same_without_numba() -> None:
    plain = in_python(forward_rows)
    Q = np.random.default_rng(2).uniform(-3.0, 3.0, (3, 6))
    from ropsim.kinematics import chain_arrays

    chain, out = chain_arrays(PUMA), np.empty((3, 4, 4))
    plain(chain.flat, Q, out, np.empty(POSES))
    np.testing.assert_allclose(out, kinematics.forward_batch(PUMA, Q), atol=ROUNDING)


@pytest.mark.parametrize("count", [1, 8, 15, 16, 17, 40])
def test_a_pose_hangs_on_no_other_row(count: int) -> None:
    Q = np.random.default_rng(count).uniform(-3.0, 3.0, (count, 6))
    alone = [kinematics.forward_batch(PUMA, row[np.newaxis])[0] for row in Q]
    np.testing.assert_array_equal(kinematics.forward_batch(PUMA, Q), alone)


def test_angles_of_many_turns_are_those_of_the_sine_and_cosine_of_numpy() -> None:
    Q = np.random.default_rng(4).uniform(-1e5, 1e5, (200, 6))
    Q[0], Q[1] = np.arange(6) * pi / 4, -np.arange(6) * pi / 2
    frames = kinematics.frames_batch(PUMA, Q)
    np.testing.assert_allclose(kinematics.forward_batch(PUMA, Q), frames[:, -1], rtol=0.0, atol=10 * ROUNDING)


def test_frames_have_the_joint_axes_as_z() -> None:
    frames = kinematics.joint_frames(PUMA, np.zeros(6))
    np.testing.assert_allclose(frames[0, :3, 2], [0, 0, 1], atol=ROUNDING)
    np.testing.assert_allclose(frames[1, :3, 2], [0, -1, 0], atol=ROUNDING)
    np.testing.assert_allclose(frames[1, :3, 3], [0, 0, 0.67183], atol=ROUNDING)


def test_no_rows_give_no_poses() -> None:
    assert kinematics.forward_batch(PUMA, np.empty((0, 6))).shape == (0, 4, 4)


def test_a_row_with_nan_gives_a_pose_with_nan() -> None:
    Q = np.zeros((2, 6))
    Q[1, 0] = np.nan
    T = kinematics.forward_batch(PUMA, Q)
    assert np.isfinite(T[0]).all()
    assert np.isnan(T[1]).any()


def test_a_wrong_number_of_coordinates_names_array_and_shapes() -> None:
    with pytest.raises(kinematics.ArrayShapeError) as caught:
        kinematics.forward(PUMA, [0.0] * 5)
    assert caught.value.diagnostic.code == "M551"
    assert caught.value.diagnostic.message == "`q` has the shape (5,), allowed is (6,)"


def test_a_vector_is_no_batch() -> None:
    with pytest.raises(kinematics.ArrayShapeError, match=r"`Q` has the shape \(6,\), allowed is \(k, 6\)"):
        kinematics.forward_batch(PUMA, np.zeros(6))


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_coordinates_that_are_not_finite_are_refused(value: float) -> None:
    with pytest.raises(kinematics.NotFiniteError, match="M552"):
        kinematics.forward(PUMA, [0.0, value, 0.0, 0.0, 0.0, 0.0])


def test_importing_kinematics_and_robots_does_not_import_numba() -> None:
    code = "import sys, ropsim.kinematics, ropsim.robots; sys.exit('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
