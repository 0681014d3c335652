"""Singular poses of closed chains: dead centres, ball joints with parallel axes, bodies without inertia."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.dynamics import FreeMotion, MissingMassError, forward_dynamics, free_motion, mass_matrix
from ropsim.kinematics import joint_motion
from ropsim.model import (
    BASE_LINK,
    Direction,
    Joint,
    JointType,
    Link,
    LoopCut,
    Mechanism,
    RobotModel,
    passive_coordinates,
)
from ropsim.spatial import Array, Pose
from support.loops import DOWN, IN_PLANE, at, energies, joint, mechanism, plane_body, rod

POINT = (Direction.X, Direction.Y, Direction.Z)
NOTHING = Link(0.0, np.zeros(3), np.zeros((3, 3)))
ALONG_X = Pose(orientation=np.array([1.0, 0.0, 1.0, 0.0]))
CRANK, ROD = 0.2, 0.8


def slider_crank(axis: int) -> RobotModel:
    """Return a slider-crank in which the crank (0) or the slider (2) is the axis."""
    slide = joint("slider", ALONG_X, BASE_LINK, JointType.PRISMATIC)
    joints = (joint("crank", at(0.0)), joint("rod", at(CRANK), 0), slide)
    links = (rod(1.0, CRANK), rod(3.0, ROD), plane_body(2.0, 0.0, 0.0, 1.0))
    made = mechanism(joints, links, (LoopCut(1, at(ROD), 2, Pose(), IN_PLANE),), 0.6, DOWN)
    return replace(made, axes=(axis,))


def crank_state(robot: RobotModel, speed: float) -> tuple[Array, Array]:
    """Return coordinates and speeds of crank, rod and slider."""
    found = joint_motion(robot, [[0.6]], [[speed]])
    places = [0, *passive_coordinates(robot)]
    return found.position[0, places], found.speed[0, places]


def test_a_slider_as_axis_passes_dead_centres_as_the_crank_does() -> None:
    """In a dead centre the slider stands and does not say where the crank goes: the masses do."""
    by_crank, by_slider = slider_crank(0), slider_crank(2)
    y, yd = crank_state(by_crank, 8.0)
    one = free_motion(by_crank, y, yd, 1e-3, 2000, every=10)
    other = free_motion(by_slider, np.roll(y, 1), np.roll(yd, 1), 1e-3, 2000, every=10)
    assert one.y[-1, 0] > 3.0 * np.pi
    assert np.abs(np.roll(other.y, -1, axis=1) - one.y).max() < 1e-9
    found = energies(by_crank, one.y, one.yd)
    assert np.abs(found - found[0]).max() < 1e-6


def euler(R: Array) -> Array:
    """Return the coordinates of a ball joint: turns about z, the turned y, the turned x."""
    return np.array([np.arctan2(R[1, 0], R[0, 0]), -np.arcsin(R[2, 0]), np.arctan2(R[2, 1], R[2, 2])])


def swinging_body(beside: float, turned: float) -> tuple[Mechanism, Array]:
    """Return a crank that swings a body about a ball joint, and its state at rest.

    The body passes the z axis of the base at an angle of about `beside`, where the first and the last axis of
    a ball joint are parallel unless its frame is turned about y by the angle `turned`.
    """
    frame = Pose(np.zeros(3), np.array([np.cos(turned / 2.0), 0.0, np.sin(turned / 2.0), 0.0]))
    crank = Pose.from_matrix(np.array([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]]))
    limits = (0.0, -40.0, 40.0, 1.0, 1.0, 1.0)
    joints = (
        Joint("crank", JointType.REVOLUTE, crank, *limits, parent=BASE_LINK),
        Joint("ball", JointType.SPHERICAL, frame, *limits, parent=BASE_LINK),
    )
    links = (
        Link(0.5, np.array([0.5, 0.0, 0.0]), np.diag([0.01, 0.05, 0.05])),
        Link(2.0, np.array([0.6, 0.05, -0.1]), np.diag([0.03, 0.2, 0.25])),
    )
    reach = float(np.hypot(beside, 1.0))
    cut = LoopCut(0, at(1.0, 0.0, beside), 1, at(reach), POINT)
    start = 2.4
    along = np.array([beside, np.cos(start), np.sin(start)]) / reach
    side = np.cross(along, [0.0, 1.0, 0.3])
    side /= np.linalg.norm(side)
    R = np.stack((along, np.cross(side, along), side), axis=1)
    robot = Mechanism("swing", "swing", joints, links, (), np.zeros(1), axes=(0,), cuts=(cut,), gravity=-DOWN)
    return robot, np.array([start, *euler(frame.rotation().T @ R)])


def swung(beside: float, turned: float) -> FreeMotion:
    robot, y = swinging_body(beside, turned)
    return free_motion(robot, y, np.zeros(4), 1e-3, 1200, every=10)


@pytest.mark.parametrize(
    ("beside", "off"),
    [(0.3, 1e-8), (0.03, 1e-5), (0.01, 1e-4), (0.001, 2e-2), (0.0, 1e-9)],
    ids=["17°", "1.7°", "0.6°", "0.06°", "through"],
)
def test_a_ball_joint_passes_parallel_axes(beside: float, off: float) -> None:
    """The crank moves as with axes that stay apart, but for this [rad]; the chain stays closed."""
    through, apart = swung(beside, 0.0), swung(beside, 1.2)
    assert np.abs(through.y[:, 0] - apart.y[:, 0]).max() < off
    assert np.ptp(apart.y[:, 0]) > 4.0
    assert max(through.gap.max(), apart.gap.max()) < 2e-9


def four_bar(links: tuple[Link, ...]) -> RobotModel:
    joints = (joint("crank", at(0.0)), joint("coupler", at(0.2), 0), joint("rocker", at(0.9)))
    return mechanism(joints, links, (LoopCut(1, at(0.8), 2, at(0.6), IN_PLANE),), 0.6, DOWN)


def test_a_coupler_without_mass_moves_as_one_of_next_to_no_mass() -> None:
    ends = []
    for coupler in (NOTHING, rod(1e-9, 0.8)):
        robot = four_bar((rod(1.0, 0.2), coupler, rod(2.0, 0.6)))
        ends.append(free_motion(robot, *crank_state(robot, 8.0), 1e-3, 1000, every=1000).y[-1])
    assert np.abs(ends[0] - ends[1]).max() < 1e-6
    assert ends[0][0] > 2.0


def test_a_chain_without_any_inertia_is_named() -> None:
    with pytest.raises(MissingMassError) as caught:
        forward_dynamics(four_bar((NOTHING,) * 3), [0.6], [0.0], [1.0])
    assert caught.value.diagnostic.code == "M590"


def test_a_rocker_alone_gives_the_crank_its_inertia() -> None:
    """The inertia of the rocker counts with the square of the ratio of speeds (J. L. Lagrange)."""
    robot = four_bar((NOTHING, NOTHING, rod(2.0, 0.6)))
    _, speeds = crank_state(robot, 1.0)
    moment = 2.0 * 0.6**2 / 3.0
    assert mass_matrix(robot, [0.6])[0, 0] == pytest.approx(moment * speeds[2] ** 2, rel=1e-9)
