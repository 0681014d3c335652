"""A coupling with a constant: where its joint stands, what it weighs, and that a track keeps it."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import gravity
from ropsim.kinematics import forward, frames_batch
from ropsim.model import Coupling, Joint, JointType, Link, RobotModel, on_track
from ropsim.spatial import Pose, frozen

FACTOR, CONSTANT, LENGTH, MASS = 0.5, 0.3, 0.4, 2.0
FLAT = Pose(np.zeros(3), np.array([np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0]))  # z of the joints across, y up
OUT = Pose(np.array([LENGTH, 0.0, 0.0]))


def arm() -> RobotModel:
    """Two links in a vertical plane; the second joint turns by half the first one and 0.3 rad more."""
    limits = (-3.0, 3.0, 1.0, 1.0, 1.0)
    joints = (
        Joint("1", JointType.REVOLUTE, FLAT, 0.0, *limits),
        Joint("2", JointType.REVOLUTE, OUT, 0.0, *limits),
    )
    link = Link(MASS, frozen([LENGTH, 0.0, 0.0]), frozen(np.zeros((3, 3))))
    return RobotModel(
        "coupled",
        "Two links, one axis",
        joints,
        (link, link),
        (),
        frozen([0.0]),
        couplings=(Coupling(1, ((0, FACTOR),), CONSTANT),),
        X_nM=OUT,
    )


def ends(q: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the ends of both links in the vertical plane, (x, z) each [m]."""
    total = q + FACTOR * q + CONSTANT
    elbow = LENGTH * np.array([np.cos(q), np.sin(q)])
    return elbow, elbow + LENGTH * np.array([np.cos(total), np.sin(total)])


@pytest.mark.parametrize("q", [-0.7, 0.0, 1.1])
def test_the_constant_turns_the_coupled_joint(q: float) -> None:
    robot = arm()
    assert robot.n == 1
    elbow, tip = ends(q)
    frames = frames_batch(robot, np.array([[q]]))[0]
    np.testing.assert_allclose(frames[1, [0, 2], 3], elbow, atol=1e-12)
    np.testing.assert_allclose(forward(robot, np.array([q])).position[[0, 2]], tip, atol=1e-12)


@pytest.mark.parametrize("q", [-0.7, 0.0, 1.1])
def test_the_torque_of_weight_is_the_slope_of_the_potential_energy(q: float) -> None:
    def energy(at: float) -> float:
        return 9.81 * MASS * sum(float(end[1]) for end in ends(at))

    step = 1e-6
    slope = (energy(q + step) - energy(q - step)) / (2.0 * step)
    assert gravity(arm(), np.array([q])).item() == pytest.approx(slope, rel=1e-8)


def test_a_track_keeps_the_constant() -> None:
    track = robots.linear_track(2.0)
    whole = on_track(arm(), track)
    X_CB = frames_batch(track, np.array([[0.25]]))[0, track.interface_link]
    expected = X_CB @ forward(arm(), np.array([0.4])).matrix()
    np.testing.assert_allclose(forward(whole, np.array([0.4, 0.25])).matrix(), expected, atol=1e-12)
