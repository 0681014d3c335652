"""Springs between bodies and on coordinates: numbers that cannot be, and springs of joined mechanisms."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim.kinematics import joint_frames
from ropsim.model import BASE_LINK, JointSpring, ModelValueError, RobotModel, Spring, beside, on_track
from ropsim.spatial import Array, Pose
from support.arms import random_arm

ARM = random_arm(1, "RRR")
SPRING = Spring(
    "balance", BASE_LINK, np.array([0.1, 0.2, 0.3]), 1, np.array([0.0, 0.1, -0.2]), 800.0, 0.2, 5.0
)
RETURN = JointSpring("return", 2, 30.0, 0.4, 1.0)
SPRUNG = replace(ARM, springs=(SPRING,), joint_springs=(RETURN,))
X = Pose(np.array([0.4, -0.3, 0.9]), np.array([0.5, 0.1, -0.7, 0.3]))


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"stiffness": -1.0}, "`stiffness` = -1"),
        ({"damping": -0.5}, "`damping` = -0.5"),
        ({"free_length": -0.1}, "`free_length` = -0.1"),
        ({"stiffness": np.nan}, "`stiffness` = nan"),
        ({"point_1": np.array([0.0, np.inf, 0.0])}, "`point_1` = inf"),
        ({"point_2": np.zeros(2)}, "`point_2` with 2 numbers"),
    ],
)
def test_a_spring_with_an_impossible_number_is_refused(change: dict[str, Any], told: str) -> None:
    with pytest.raises(ModelValueError, match=f"spring `balance` has {told}") as caught:
        replace(ARM, springs=(replace(SPRING, **change),))
    assert caught.value.diagnostic.code == "X977"


@pytest.mark.parametrize(
    ("change", "told"),
    [({"stiffness": -1.0}, "stiffness"), ({"rest": np.nan}, "rest"), ({"damping": np.inf}, "damping")],
)
def test_a_joint_spring_with_an_impossible_number_is_refused(change: dict[str, Any], told: str) -> None:
    with pytest.raises(ModelValueError, match=f"joint spring `return` has `{told}`"):
        replace(ARM, joint_springs=(replace(RETURN, **change),))


def lengths(robot: RobotModel, q: Array) -> list[float]:
    """Return the lengths of the springs between bodies [m]."""
    frames = [*joint_frames(robot, q)[:-1], np.eye(4)]  # that of the base is at BASE_LINK

    def place(link: int, point: Array) -> Array:
        return np.asarray(frames[link][:3, :3] @ point + frames[link][:3, 3])

    return [
        float(np.linalg.norm(place(one.link_2, one.point_2) - place(one.link_1, one.point_1)))
        for one in robot.springs
    ]


def test_springs_of_joined_mechanisms_stay_where_they_were() -> None:
    q, other = np.array([0.3, -0.7, 1.1]), np.array([-0.2, 0.5, 0.8])
    whole = [*lengths(SPRUNG, q), *lengths(SPRUNG, other)]
    for joined, order in ((on_track(SPRUNG, SPRUNG, X), (1, 0)), (beside(SPRUNG, SPRUNG, X), (0, 1))):
        found = lengths(joined, np.concatenate((q, other)))
        assert np.allclose(found, [whole[k] for k in order], rtol=0.0, atol=1e-14)
        assert [one.coordinate for one in joined.joint_springs] == [2, 5]
