"""The base frame: where the world's poses become those of a robot's programs."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.model import in_base
from ropsim.spatial import Pose
from support.examples import examples

#: Rounding of two compositions of poses with coordinates of a few metres.
ROUNDING = 1e-12
NUMBER = st.floats(-3.0, 3.0)


@st.composite
def poses(draw: st.DrawFn) -> Pose:
    place = np.array([draw(NUMBER) for _ in range(3)])
    return Pose(place, np.array([2.0, *(draw(st.floats(-1.0, 1.0)) for _ in range(3))]))


@settings(max_examples=examples(100), derandomize=True)
@given(poses(), poses())
def test_the_base_takes_a_pose_back_to_the_world(X_WB: Pose, X_WA: Pose) -> None:
    back = X_WB @ in_base(X_WB, {"a": X_WA})["a"]
    np.testing.assert_allclose(back.matrix(), X_WA.matrix(), atol=ROUNDING)


@settings(max_examples=examples(100), derandomize=True)
@given(poses())
def test_a_base_at_the_origin_of_the_world_changes_no_bit(X_WA: Pose) -> None:
    assert in_base(Pose(), {"a": X_WA})["a"].as_tuple() == X_WA.as_tuple()
