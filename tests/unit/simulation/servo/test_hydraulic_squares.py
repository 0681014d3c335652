"""A hydraulic arm of two links draws a square of 10 cm at four places, each axis under a PI regulator.

It is the trial of the two-link arm of MULTIDOS; published numbers of that arm were not found, those of this
one are round and of the size of heavy test arms. What the regulators leave of a path depends on the place:
gravity, masses and coupling of the axes do.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim.controller import cascaded_p_pi
from ropsim.core import SourceText
from ropsim.flow import JointReference
from ropsim.kinematics import forward_batch
from ropsim.model import CascadedGains, HydraulicMotor, Payload, Rates, RobotModel
from ropsim.robotfile import read_robot_file
from ropsim.robots.standard_controller import cascaded_controller
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import drive
from support.servo_cases import standing

UPPER, FORE = 1.0, 0.9
VALVE = "rated_pressure_drop = 7e6, rated_input = 0.05, natural_frequency = 630, damping_ratio = 0.8"
OIL = "supply_pressure = 21e6, return_pressure = 2e5, bulk_modulus = 1.2e9"
TEXT = f"""
convention = "standard"
base = {{ rpy = [90, 0, 0] }}
units = {{ length = "m" }}
home = [60, -100]
joints = [
  {{ a = {UPPER}, limits = [-30, 120], speed = 60 }},
  {{ a = {FORE}, limits = [-150, -10], speed = 60 }},
]
links = [
  {{ mass = 60, com = [-0.5, 0, 0], inertia = [0.2, 5, 5, 0, 0, 0] }},
  {{ mass = 35, com = [-0.5, 0, 0], inertia = [0.1, 2.5, 2.5, 0, 0, 0] }},
]
drives = [
  {{ kind = "hydraulic", displacement = 1.6e-4, chamber_volume = 2.5e-4, leakage = 2e-12, rotor_inertia = 0.1,
     rated_flow = 6.3e-4, viscous = 50, {OIL}, {VALVE} }},
  {{ kind = "hydraulic", displacement = 0.8e-4, chamber_volume = 1.2e-4, leakage = 1.2e-12,
     rotor_inertia = 0.05, rated_flow = 3.2e-4, viscous = 25, {OIL}, {VALVE} }},
]
"""
PLACES = ((1.0, 0.6), (1.5, 0.2), (0.8, 1.1), (1.2, -0.2))
"""Middles of the squares in the plane of the arm [m]."""
SIDE, TICKS = 0.1, 400
"""[m], and control ticks for a side."""


@dataclass(frozen=True)
class Drawn:
    """A square as it was drawn.

    Attributes:
        off: distance of the tip from where it should be, at each tick [m].
        settled: the same half a second after the end [m].
        pressures: of the four chambers, (k, 4) [Pa].
    """

    off: Array
    settled: float
    pressures: Array


@pytest.fixture(scope="module")
def robot() -> RobotModel:
    read = read_robot_file(SourceText("robots/arm.toml", TEXT.replace(",\n     ", ", ")))
    assert read.robot is not None, read.findings
    return read.robot


@pytest.fixture(scope="module")
def drawn(robot: RobotModel) -> list[Drawn]:
    model = cascaded_controller(robot, Rates())
    servo = Servo.build(robot, model, cascaded_p_pi(model, robot))
    return [draw(robot, servo, np.array(place)) for place in PLACES]


def draw(robot: RobotModel, servo: Servo, middle: Array) -> Drawn:
    corners = middle + SIDE / 2 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])
    u = (np.arange(TICKS) + 1.0)[:, None] / TICKS
    share = 10.0 * u**3 - 15.0 * u**4 + 6.0 * u**5
    points = np.vstack([a + share * (b - a) for a, b in pairwise(corners)])
    q = np.array([angles(point) for point in points])
    rates = np.gradient(q, 1e-3, axis=0)
    reference = JointReference(q, rates, np.gradient(rates, 1e-3, axis=0))
    start = servo.initial_state(angles(corners[0]))
    recorder = servo.recorder(start)
    end = servo.run(start, reference, Payload(), recorder)
    servo.run(end, standing(q[-1], 500), Payload(), recorder)
    rows = recorder.channels()
    tips = forward_batch(robot, np.ascontiguousarray(rows["q"][1:]))[:, (0, 2), 3]
    wanted = np.vstack((points, np.tile(corners[-1], (500, 1))))
    off = np.hypot(*(tips - wanted).T)
    pressures = np.column_stack((rows["pressure_a"], rows["pressure_b"]))
    return Drawn(off[: len(points)], float(off[-1]), pressures)


def angles(point: Array) -> Array:
    """Return both angles of the arm with its elbow up [rad]."""
    c = (point @ point - UPPER**2 - FORE**2) / (2.0 * UPPER * FORE)
    elbow = -np.arccos(c)
    ahead = np.arctan2(FORE * np.sin(elbow), UPPER + FORE * c)
    return np.array([np.arctan2(point[1], point[0]) - ahead, elbow])


def test_each_axis_has_a_pi_regulator_at_a_share_of_what_leaks(robot: RobotModel) -> None:
    motors = [one.motor for one in robot.drives if isinstance(one.motor, HydraulicMotor)]
    tighter = tuple(
        replace(one, motor=replace(motor, leakage=0.5 * motor.leakage))
        for one, motor in zip(robot.drives, motors, strict=True)
    )
    gains = cascaded_controller(replace(robot, drives=tighter), Rates()).gains
    assert isinstance(gains, CascadedGains)
    crossover = 0.7 * min(2.0 * 1.2e9 * 1e-12 / 2.5e-4, 2.0 * 1.2e9 * 0.6e-12 / 1.2e-4)
    np.testing.assert_allclose(gains.ki / gains.ke, crossover)
    np.testing.assert_array_equal([gains.kv, gains.ka, gains.kf], [[0.0, 0.0], [0.0, 0.0], [1.0, 1.0]])


def test_an_axis_with_another_motor_keeps_its_own_loops(robot: RobotModel) -> None:
    mixed = replace(robot, drives=(robot.drives[0], drive(ratio=120.0)))
    electric = replace(robot, drives=(drive(ratio=120.0),) * 2)
    gains, alone = cascaded_controller(mixed, Rates()).gains, cascaded_controller(electric, Rates()).gains
    assert isinstance(gains, CascadedGains)
    assert isinstance(alone, CascadedGains)
    assert gains.kv[0] == 0.0 < gains.kv[1]
    assert gains.ke[1] == alone.ke[1]


def test_the_regulators_follow_and_come_to_rest_where_they_should(drawn: list[Drawn]) -> None:
    for square in drawn:
        assert 1e-3 < square.off.max() < 10e-3
        assert square.settled < 0.12 * square.off.max()


def test_errors_differ_with_the_place(drawn: list[Drawn]) -> None:
    largest = [float(square.off.max()) for square in drawn]
    assert max(largest) > 1.4 * min(largest)
    assert len({round(1e4 * one) for one in largest}) == len(PLACES)


def test_both_chambers_of_a_motor_share_supply_and_return(drawn: list[Drawn]) -> None:
    for square in drawn:
        a, b = square.pressures[:, :2], square.pressures[:, 2:]
        np.testing.assert_allclose(a + b, 21.2e6, rtol=1e-3)
        assert 2e5 < square.pressures.min() < square.pressures.max() < 21e6
