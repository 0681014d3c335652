"""Reading of channels that may be absent or be there for some joints only."""

import numpy as np
import pytest

from ropsim.flow import Channel, Recording
from ropsim.views.channels import matrix

TIME = np.arange(3.0)
JOINTS = ("shoulder", "slide", "wrist")


def _recording(**channels: Channel) -> Recording:
    q = Channel(np.zeros((3, 3)), "rad", JOINTS)
    return Recording(TIME, {"q": q, **channels}, (), (), 2.0)


def test_a_quantity_of_some_joints_is_unknown_for_the_others() -> None:
    current = Channel(np.array([[1.0, 2.0], [3.0, 4.0], [5.0, np.inf]]), "A", ("wrist", "shoulder"))
    found = matrix(_recording(current=current), "current", 3)
    np.testing.assert_array_equal(found[:, 0], [2.0, 4.0, np.nan])
    assert np.isnan(found[:, 1]).all()
    np.testing.assert_array_equal(found[:, 2], [1.0, 3.0, 5.0])


@pytest.mark.parametrize(
    "channel",
    [
        Channel(np.zeros((3, 2)), "A", ("elbow", "wrist")),
        Channel(np.zeros((3, 2)), "A"),
        Channel(np.zeros((2, 1)), "A", ("wrist",)),
        Channel(np.zeros(3), "A"),
    ],
)
def test_what_belongs_to_no_joint_is_not_read(channel: Channel) -> None:
    assert np.isnan(matrix(_recording(current=channel), "current", 3)).all()


def test_an_absent_channel_is_unknown() -> None:
    assert np.isnan(matrix(_recording(), "current", 3)).all()
