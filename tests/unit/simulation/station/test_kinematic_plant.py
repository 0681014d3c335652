"""The ideal arm: standing still is following a reference that stands."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import JointReference
from ropsim.model import Payload
from ropsim.simulation.testing import KinematicPlant, constant

ARM = robots.load("scara")
BEYOND = np.where(np.arange(ARM.n) == 1, ARM.upper_limits + 0.1, ARM.home)
MOST_ROWS = 20


@pytest.mark.parametrize("record_ticks", [1, 3, 50])
def test_to_stand_is_to_follow_a_reference_that_stands(record_ticks: int) -> None:
    stands, follows = (KinematicPlant(ARM, ARM.home, record_ticks, MOST_ROWS) for _ in range(2))
    way = np.linspace(ARM.home, BEYOND, 4)
    moved = replace(constant(ARM.home, 4), q=way, qd=np.full_like(way, 0.3))
    for part in (7, moved, 1, 12, moved, 40):
        for plant in (stands, follows):
            if isinstance(part, JointReference):
                plant.follow(part, Payload())
            elif plant is stands:
                plant.hold(plant.q, part, Payload())
            else:
                plant.follow(constant(plant.q, part), Payload())
        for tick in np.arange(0.0, 80.0, 0.5):
            np.testing.assert_array_equal(stands.q_at(tick), follows.q_at(tick))
        np.testing.assert_array_equal(stands.qd, follows.qd)
    np.testing.assert_array_equal(stands.tally.table, follows.tally.table)
    assert stands.log().keys() == follows.log().keys()
    for name, values in stands.log().items():
        np.testing.assert_array_equal(values, follows.log()[name], err_msg=name)
