"""A two-link hydraulic arm of about man size, lifted by cylinders, and the squares that it draws.

Its numbers are round and of the size of test arms for heavy loads; they were published by nobody.
"""

from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from math import pi

import numpy as np

from ropsim.core import SourceText
from ropsim.flow import JointReference
from ropsim.model import Friction, Hydraulic, Payload, RobotModel
from ropsim.robotfile import read_robot_file
from ropsim.spatial import Array

UPPER, FORE, HEIGHT = 1.2, 1.1, 1.0
"""Lengths of the links, and of the shoulder above the floor [m]."""
_CYLINDER = (
    'kind = "cylinder", area_a = {a}, area_b = {b}, stroke = {stroke}, retracted_length = {short}, '
    "carrier_pin = {carrier}, link_pin = {link}, dead_volume_a = {dead}, dead_volume_b = {dead}, "
    "moving_mass = {mass}, leakage = {leak}, supply_pressure = 140e5, return_pressure = 3e5, "
    "bulk_modulus = 1.2e9, rated_flow = {flow}, rated_pressure_drop = 70e5, rated_input = 0.04, "
    "natural_frequency = 628, damping_ratio = 0.8, viscous = {viscous}, coulomb = {dry}, "
    "smoothing_speed = 0.01"
)


def _areas(piston: float, rod: float) -> dict[str, float]:
    """Return the areas of a cylinder of diameters [mm] in m²."""
    return {"a": pi / 4e6 * piston**2, "b": pi / 4e6 * (piston**2 - rod**2)}


_SHOULDER = _CYLINDER.format(
    **_areas(40, 25),
    stroke=0.42,
    short=0.665,
    carrier=[0.175, -0.244, 0],
    link=[0.80 - UPPER, -0.06, 0],
    dead=4e-5,
    mass=4,
    leak=1.5e-12,
    flow=19e-3 / 60,
    viscous=1500,
    dry=150,
)
_ELBOW = _CYLINDER.format(
    **_areas(32, 20),
    stroke=0.38,
    short=0.595,
    carrier=[-0.74, 0.13, 0],
    link=[-0.246 - FORE, 0.043, 0],
    dead=3e-5,
    mass=2.5,
    leak=1e-12,
    flow=10e-3 / 60,
    viscous=1200,
    dry=100,
)
TEXT = f"""
convention = "standard"
base = {{ position = [0, 0, {HEIGHT}], rpy = [90, 0, 0] }}
units = {{ length = "m" }}
home = [55, -100]
joints = [
  {{ name = "shoulder", a = {UPPER}, limits = [5, 100], speed = 60, acceleration = 240, jerk = 2400 }},
  {{ name = "elbow", a = {FORE}, limits = [-145, -45], speed = 70, acceleration = 300, jerk = 3000 }},
]
links = [
  {{ mass = 45, com = [-0.6, 0, 0], inertia = [0.3, 5.5, 5.5, 0, 0, 0] }},
  {{ mass = 25, com = [-0.65, 0, 0], inertia = [0.2, 2.6, 2.6, 0, 0, 0] }},
]
drives = [
  {{ {_SHOULDER} }},
  {{ {_ELBOW} }},
]
"""
LOAD = Payload(10.0)
"""At the tip."""
SQUARES = {
    "near low": (0.85, 0.70),
    "far low": (1.85, 0.70),
    "far high": (1.85, 1.30),
    "near high": (0.85, 1.30),
}
"""Lower left corners in the plane of the arm [m]."""
SIDE, SPEED, ACCELERATION, JERK, PERIOD = 0.1, 0.3, 3.0, 60.0, 1e-3
BEFORE, AFTER = 300, 1000
"""Control ticks at rest, before and behind a square."""


@cache
def hydraulic_arm() -> RobotModel:
    """Return the arm."""
    read = read_robot_file(SourceText("robots/arm.toml", TEXT))
    assert read.robot is not None, read.findings
    return read.robot


def mistaken(
    robot: RobotModel,
    mass: float = 0.8,
    oil: float = 1.4,
    flow: float = 1.1,
    friction: float = 0.5,
    leakage: float = 0.5,
) -> RobotModel:
    """Return the arm that a law believes in: lighter, with stiffer oil and larger valves, by factors."""
    links = tuple(replace(one, mass=mass * one.mass, inertia=mass * one.inertia) for one in robot.links)
    drives = []
    for drive in robot.drives:
        motor, rubs = drive.motor, drive.friction
        assert isinstance(motor, Hydraulic)
        assert isinstance(rubs, Friction)
        motor = replace(
            motor,
            bulk_modulus=oil * motor.bulk_modulus,
            rated_flow=flow * motor.rated_flow,
            leakage=leakage * motor.leakage,
        )
        dry = friction * rubs.coulomb_positive, friction * rubs.coulomb_negative
        rubs = Friction(friction * rubs.viscous, *dry, smoothing_speed=rubs.smoothing_speed)
        drives.append(replace(drive, motor=motor, friction=rubs))
    return replace(robot, links=links, drives=tuple(drives))


def angles(points: Array) -> Array:
    """Return both angles with the elbow up [rad], shape (k, 2), of points of the tip [m], shape (k, 2)."""
    x, z = points[..., 0], points[..., 1] - HEIGHT
    elbow = -np.arccos((x * x + z * z - UPPER**2 - FORE**2) / (2.0 * UPPER * FORE))
    ahead = np.arctan2(FORE * np.sin(elbow), UPPER + FORE * np.cos(elbow))
    return np.stack([np.arctan2(z, x) - ahead, elbow], -1)


def tips(q: Array) -> Array:
    """Return the points of the tip [m], shape (k, 2), of angles [rad], shape (k, 2)."""
    one, both = q[..., 0], q[..., 0] + q[..., 1]
    x = UPPER * np.cos(one) + FORE * np.cos(both)
    return np.stack([x, HEIGHT + UPPER * np.sin(one) + FORE * np.sin(both)], -1)


@dataclass(frozen=True)
class Square:
    """A square to be drawn, with a stop at each corner.

    Attributes:
        corners: (5, 2) [m].
        points: of the tip at each tick, (k, 2) [m].
        reference: of the joints at each tick.
    """

    corners: Array
    points: Array
    reference: JointReference


def square(name: str) -> Square:
    """Return a square at 0.3 m/s, 3 m/s² and 60 m/s³."""
    corners = np.array(SQUARES[name]) + SIDE * np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]])
    flat = [np.full(round(SIDE / SPEED / PERIOD), 1.0), np.full(round(SPEED / ACCELERATION / PERIOD), 1.0)]
    flat.append(np.full(round(ACCELERATION / JERK / PERIOD), 1.0))
    profile = flat[0] / len(flat[0])
    for one in flat[1:]:
        profile = np.convolve(profile, one / len(one))
    share = np.cumsum(profile)[:, None]
    sides = [a + share * (b - a) for a, b in pairwise(corners)]
    points = np.vstack([np.tile(corners[0], (BEFORE, 1)), *sides, np.tile(corners[4], (AFTER, 1))])
    q = angles(points)
    qd = np.gradient(q, PERIOD, axis=0)
    return Square(corners, points, JointReference(q, qd, np.gradient(qd, PERIOD, axis=0)))


@dataclass(frozen=True)
class Errors:
    """How well a square was drawn [m].

    Attributes:
        path: largest distance from the outline.
        path_mean: mean of that while it is drawn.
        tracking: largest distance from where the tip should be at the time.
        end: distance at the planned end.
    """

    path: float
    path_mean: float
    tracking: float
    end: float


def errors(drawn: Array, wanted: Square) -> Errors:
    """Return the errors of attained coordinates at each tick [rad], shape (k, 2)."""
    attained = tips(drawn)
    off = np.hypot(*(attained - wanted.points).T)
    distance = np.full(len(attained), np.inf)
    for a, b in pairwise(wanted.corners):
        along = np.clip((attained - a) @ (b - a) / SIDE**2, 0.0, 1.0)
        distance = np.minimum(distance, np.hypot(*(attained - a - along[:, None] * (b - a)).T))
    end = len(attained) - AFTER
    path = distance[BEFORE:]
    return Errors(
        float(path.max()), float(distance[BEFORE:end].mean()), float(off.max()), float(off[end - 1])
    )
