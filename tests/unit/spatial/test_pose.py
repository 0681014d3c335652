import numpy as np
import pytest

from ropsim.spatial import Pose, quaternion


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
