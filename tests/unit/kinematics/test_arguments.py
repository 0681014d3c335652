"""Whatever is given for an array of numbers, the answer is an array or an error with a diagnostic."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from ropsim import dynamics, kinematics, robots
from ropsim.core import RopsimError
from ropsim.spatial import Pose

ROBOT = robots.load("puma560")
REST = np.zeros(6)

CALLS: dict[str, Callable[[Any], object]] = {
    "forward": lambda x: kinematics.forward(ROBOT, x),
    "forward_batch": lambda x: kinematics.forward_batch(ROBOT, x),
    "jacobian": lambda x: kinematics.jacobian(ROBOT, x),
    "inverse_batch": lambda x: kinematics.inverse_batch(ROBOT, x),
    "gravity": lambda x: dynamics.gravity(ROBOT, x),
    "mass_matrix": lambda x: dynamics.mass_matrix(ROBOT, x),
    "inverse_dynamics": lambda x: dynamics.inverse_dynamics(ROBOT, REST, x, REST),
    "forward_dynamics": lambda x: dynamics.forward_dynamics(ROBOT, REST, REST, x),
    "wrench": lambda x: dynamics.inverse_dynamics(ROBOT, REST, REST, REST, wrench=x),
}

WRONG: dict[str, object] = {
    "texts": ["a"] * 6,
    "texts that are numbers": ["1"] * 6,
    "complex": np.zeros(6, dtype=complex),
    "objects": [object()] * 6,
    "unequal lists": [[0.0], [1.0, 2.0]],
    "too few": np.zeros(5),
    "one number": 1.0,
    "nothing": [],
}


@pytest.mark.parametrize("wrong", WRONG)
@pytest.mark.parametrize("call", CALLS)
def test_what_is_no_fitting_array_is_refused_with_a_diagnostic(call: str, wrong: str) -> None:
    with pytest.raises(RopsimError) as caught:
        CALLS[call](WRONG[wrong])
    assert caught.value.diagnostic.code in {"M551", "M552", "M570"}


@pytest.mark.parametrize("values", [[0] * 6, (False,) * 6, np.zeros(12, np.float32)[::2]])
def test_any_real_numbers_are_taken(values: Any) -> None:
    assert kinematics.forward(ROBOT, values) == kinematics.forward(ROBOT, REST)
    assert np.array_equal(dynamics.gravity(ROBOT, values), dynamics.gravity(ROBOT, REST))


def test_a_pose_that_is_not_finite_is_refused_and_not_called_out_of_reach() -> None:
    with pytest.raises(RopsimError, match="M552"):
        kinematics.inverse(ROBOT, Pose(np.array([np.nan, 0.0, 0.5])))
