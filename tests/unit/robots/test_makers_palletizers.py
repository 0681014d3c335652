"""Palletizers of makers: parallelograms close, the flange is level, the reach is that of the designation."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import forward_batch, frames_batch
from ropsim.model import coupled_limits
from ropsim.spatial import Array

CLOSED = 1e-12  # [m]
LEVEL = 1e-9  # [rad]
ANYWHERE = np.random.default_rng(4).uniform(-np.pi, np.pi, (50, 4))
LENGTHS = {"irb460_110_240": (0.945, 1.025), "irb660_180_315": (1.28, 1.35), "m410ib_700": (1.22, 1.3)}
"""Lower arm and forearm [m]."""


@pytest.mark.parametrize("name", LENGTHS)
def test_the_flange_is_level_and_each_rod_ends_at_the_pin_that_holds_it(name: str) -> None:
    robot, (lower_arm, forearm) = robots.load(name), LENGTHS[name]
    frames = dict(
        zip([one.name for one in robot.joints], frames_batch(robot, ANYWHERE).swapaxes(0, 1), strict=False)
    )

    def points(body: str, x: float, y: float = 0.0) -> Array:
        return np.asarray(frames[body] @ np.array([x, y, 0.0, 1.0]))

    crank, (px, py) = 0.35 * lower_arm, (-0.16 * lower_arm, -0.17 * lower_arm)
    for rod, length, held_by, x, y in (
        ("rod", lower_arm, "elbow", -crank, 0.0),
        ("lower link", lower_arm, "triangle", px, py),
        ("upper link", forearm, "wrist", px, py),
    ):
        np.testing.assert_allclose(points(rod, length), points(held_by, x, y), rtol=0.0, atol=CLOSED)
    assert np.linalg.norm(forward_batch(robot, ANYWHERE)[:, :2, 2], axis=1).max() < LEVEL


@pytest.mark.parametrize(("name", "reach"), [("irb460_110_240", 2.403), ("irb660_180_315", 3.15)])
def test_drawn_out_they_come_as_far_as_their_designations_say(name: str, reach: float) -> None:
    (entry,) = (one for one in robots.catalogue() if one.name == name)
    assert entry.reach == pytest.approx(reach, abs=2e-3)


@pytest.mark.parametrize("name", LENGTHS)
def test_the_forearm_has_limits_against_the_lower_arm(name: str) -> None:
    both = coupled_limits(robots.load(name))
    assert [one.name for one in both.joints] == ["elbow"]
    np.testing.assert_array_equal(both.T, [[0.0, -1.0, 1.0, 0.0]])
