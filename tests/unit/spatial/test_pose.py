import numpy as np
import pytest

from ropsim.core import RopsimError
from ropsim.spatial import Pose, PoseError, quaternion


def test_a_pose_is_frozen_and_normalised() -> None:
    pose = Pose(np.array([1.0, 2.0, 3.0]), np.array([0.0, -2.0, 0.0, 0.0]))
    assert pose.orientation.tolist() == [0.0, -1.0, 0.0, 0.0]
    with pytest.raises(ValueError, match="read-only"):
        pose.position[0] = 5.0


def test_equal_numbers_are_equal_poses_with_equal_hashes() -> None:
    assert Pose() == Pose(np.zeros(3))
    assert hash(Pose()) == hash(Pose(np.zeros(3)))
    assert Pose() != Pose(np.ones(3))


def test_a_quaternion_without_direction_is_refused() -> None:
    with pytest.raises(ValueError, match="no direction"):
        quaternion.normalize((0.0, 0.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="no direction"):
        quaternion.normalize((float("nan"), 0.0, 0.0, 0.0))


def test_what_is_no_pose_is_refused_with_shape_found_and_allowed() -> None:
    with pytest.raises(PoseError, match=r"position of a pose is of shape \(2,\), it must be of shape \(3,\)"):
        Pose(np.zeros(2))
    with pytest.raises(PoseError, match="direction"):
        Pose(np.zeros(3), np.zeros(4))
    with pytest.raises(RopsimError, match="3 numbers"):
        Pose("here")  # type: ignore[arg-type]  # the fault that is tested
