"""Reading of channels that may be absent or be there for some joints only."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import AxisFacts, Channel, Recording, RunFacts, StationFacts
from ropsim.spatial import Array
from ropsim.views.testing import station_views

TIME = np.arange(3.0)
JOINTS = ("shoulder", "slide", "wrist")


STATION = StationFacts("robot", axes=tuple(AxisFacts(name) for name in JOINTS))


def current_of(**channels: Channel) -> Array:
    """Return the current of each joint in a recording with these channels, shape (3, 3)."""
    (station,) = station_views(Recording(TIME, channels, (), (), 2.0, RunFacts(stations=(STATION,))))
    return station.joints("current")


def test_a_quantity_of_some_joints_is_unknown_for_the_others() -> None:
    current = Channel(np.array([[1.0, 2.0], [3.0, 4.0], [5.0, np.inf]]), "A", ("wrist", "shoulder"))
    found = current_of(current=current)
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
    assert np.isnan(current_of(current=channel)).all()


def test_an_absent_channel_is_unknown() -> None:
    assert np.isnan(current_of()).all()


def test_stations_have_channels_of_their_own() -> None:
    q = {
        f"{name}/q": Channel(np.full((3, 3), number), "rad", JOINTS)
        for name, number in (("left", 1.0), ("right", 2.0))
    }
    facts = RunFacts(stations=tuple(replace(STATION, name=name) for name in ("left", "right")))
    left, right = station_views(Recording(TIME, q, (), (), 2.0, facts))
    assert (left.joints("q")[0, 0], right.joints("q")[0, 0]) == (1.0, 2.0)
    assert right.label("joint 1") == "right joint 1"
