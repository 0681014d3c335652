"""A ball screw against closed forms: acceleration, lifting and lowering, a coasting slide; and in files."""

from dataclasses import replace
from math import ceil, pi

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.core import SourceText
from ropsim.dynamics import chain_of, drive_fault, reflected_inertia
from ropsim.model import (
    BallScrew,
    DcMotor,
    Drive,
    EffortAmplifier,
    Gear,
    IdealMotor,
    JointType,
    Link,
    Payload,
    Rates,
    RobotModel,
    VoltageAmplifier,
    lead_of_turn,
    lead_per_turn,
    usual_back_efficiency,
)
from ropsim.nirox import read_nirox, write_nirox
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.simulation import Servo
from ropsim.simulation.testing import STEEPEST_PRODUCT, friction_rates, plant_steps_of
from ropsim.spatial import Pose
from support.drives import slopes_of
from support.servo_cases import quintic

MASS, LEAD, ROTOR, SCREW = 40.0, 0.01, 3e-4, 5e-4
AHEAD, BACK = 0.9, 0.85
DRIVE = Drive(EffortAmplifier(50.0), IdealMotor(ROTOR), BallScrew(lead_of_turn(LEAD), AHEAD, BACK, SCREW))
RATIO = 2.0 * pi / LEAD
MOVED = MASS + (ROTOR + SCREW) * RATIO**2
FAST = 0.2
"""Far above the speed over which the losses turn round [m/s]."""


def slide(drive: Drive = DRIVE, gravity: float = 0.0) -> RobotModel:
    """Return a slide of 40 kg along z of the base under a gravity along z [m/s²]."""
    robot = robots.load("two_link")
    joint = replace(
        robot.joints[0], type=JointType.PRISMATIC, placement=Pose(), lower=-2.0, upper=2.0, max_speed=1.0
    )
    link = Link(MASS, np.zeros(3), 0.01 * np.eye(3))
    one = replace(robot, joints=(joint,), links=(link,), drives=(drive,), home=np.zeros(1))
    return replace(one, axes=(0,), tip=0, X_nM=Pose(), gravity=np.array([0.0, 0.0, gravity]), dh=())


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("speed", [FAST, -FAST])
@pytest.mark.parametrize("torque", [2.0, -3.0])
def test_a_torque_accelerates_slide_screw_and_rotor(torque: float, speed: float, sense: float) -> None:
    """(m + (J + J_s)·G²)·a = G·τ·η₁ where the motor drives, G·τ/η₂ where it brakes; any sense of the lead."""
    screw = BallScrew(sense * lead_of_turn(LEAD), AHEAD, BACK, SCREW)
    rates = slopes_of(slide(replace(DRIVE, transmission=screw)))
    force = sense * RATIO * torque
    passed = force * AHEAD if force * speed > 0.0 else force / BACK
    assert rates(np.array([0.0, speed]), torque)[1] == pytest.approx(passed / MOVED, rel=1e-9)


def test_the_screw_turns_with_the_rotor() -> None:
    assert reflected_inertia(DRIVE, 0.0) == pytest.approx((ROTOR + SCREW) * RATIO**2, rel=1e-12)


def test_lifting_and_lowering_take_the_torques_of_the_data_sheet() -> None:
    """F/(G·η₁) up and F·η₂/G down; up and down again a turn loses the difference."""
    weight = MASS * 9.81
    rates = slopes_of(slide(gravity=-9.81))
    up, down = weight / (RATIO * AHEAD), weight * BACK / RATIO
    assert rates(np.array([0.0, FAST]), up)[1] == pytest.approx(0.0, abs=1e-9)
    assert rates(np.array([0.0, -FAST]), down)[1] == pytest.approx(0.0, abs=1e-9)
    assert up > weight / RATIO > down


def test_threads_under_the_largest_force_set_the_steps() -> None:
    """(1/η₂ - 1)·F/v_s over what is moved: a light slide needs shorter ones."""
    light = replace(DRIVE, motor=IdealMotor(1e-6), transmission=BallScrew(lead_of_turn(LEAD), AHEAD, BACK))
    robot = slide(light)
    moved = MASS + 1e-6 * RATIO**2
    rate = (1.0 / BACK - 1.0) * 50.0 * RATIO / 5e-3 / moved
    assert friction_rates(robot).rates[0] == pytest.approx(rate, rel=1e-9)
    assert plant_steps_of(robot, Rates(1000)) == ceil(1e-3 * rate / STEEPEST_PRODUCT) > 2


def test_a_braked_slide_stops_as_the_closed_form_says() -> None:
    """Constant deceleration G·τ/(η₂·m) down to where the losses turn round."""
    rates, torque = slopes_of(slide()), -4.0
    found = solve_ivp(
        lambda _, x: rates(x, torque), (0.0, 0.05), [0.0, 0.5], rtol=1e-10, atol=1e-12, method="LSODA"
    )
    slower = RATIO * torque / BACK / MOVED
    assert found.y[1, -1] == pytest.approx(0.5 + slower * 0.05, rel=1e-6)
    assert found.y[0, -1] == pytest.approx(0.5 * 0.05 + 0.5 * slower * 0.05**2, rel=1e-6)


def test_the_standard_controller_moves_it_to_its_place() -> None:
    robot = slide(gravity=-9.81)
    servo = Servo.build(robot, robots.default_controller(robot, Rates(1000)))
    start = servo.initial_state(np.array([0.0]))
    reference = quintic(np.array([0.0]), np.array([0.3]), 800)
    end = servo.run(start, reference, Payload(), servo.recorder(start))
    assert end.q[0] == pytest.approx(0.3, abs=2e-4)


def test_a_linear_motor_is_a_dc_motor_without_a_gear() -> None:
    """m·a = k_f·i at once, and at full voltage no faster than u/k_e."""
    motor = DcMotor(60.0, 60.0, 4.0, 4e-3, 2.0)
    drive = Drive(VoltageAmplifier(120.0, 40.0), motor, Gear())
    rates = slopes_of(slide(drive))
    found = solve_ivp(lambda _, x: rates(x, 120.0), (0.0, 2.0), [0.0, 0.0, 0.0], rtol=1e-9, method="LSODA")
    assert found.y[1, -1] == pytest.approx(120.0 / 60.0, rel=1e-6)
    assert rates(np.array([0.0, 0.0, 5.0]), 0.0)[1] == pytest.approx(60.0 * 5.0 / (MASS + 2.0))


@pytest.mark.parametrize("turn", [0.01, -0.005, 0.016, 0.1, 1e-3, 0.0254])
def test_the_lead_of_a_turn_is_written_as_it_was_read(turn: float) -> None:
    assert lead_per_turn(lead_of_turn(turn)) == turn


def test_a_screw_of_half_efficiency_locks_itself() -> None:
    assert usual_back_efficiency(0.9) == pytest.approx(0.8888888888888889)
    assert usual_back_efficiency(0.5) == 0.0


@pytest.mark.parametrize(
    ("change", "name"),
    [
        (BallScrew(0.0), "magnitude of `ratio`"),
        (BallScrew(1e-3, 1.2), "`efficiency`"),
        (BallScrew(1e-3, 0.9, 0.0), "`back_efficiency`"),
        (BallScrew(1e-3, 0.9, 0.9, -1.0), "`screw_inertia`"),
    ],
)
def test_impossible_screws_are_faults(change: BallScrew, name: str) -> None:
    fault = drive_fault(replace(DRIVE, transmission=change))
    assert fault is not None
    assert fault[0] == name
    assert drive_fault(DRIVE) is None


TEXT = """
convention = "standard"
joints = [{ type = "prismatic", limits = [0, 500], speed = 500 }]
links = [{ mass = 10, com = [0, 0, 0], inertia = [0.1, 0.1, 0.1, 0, 0, 0] }]

[[drives]]
kind = "servo"
lead = 0.01
efficiency = 0.9
back_efficiency = 0.85
screw_inertia = 5e-4
rotor_inertia = 3e-4
max_torque = 50
"""


def read(text: str) -> tuple[RobotModel | None, list[str]]:
    found = read_robot_file(SourceText("robots/slide.toml", text))
    return found.robot, [one.message for one in found.findings]


def test_files_keep_a_screw() -> None:
    robot, _ = read(TEXT)
    assert robot is not None
    assert robot.drives == (DRIVE,)
    assert read(write_robot_file(robot).text)[0] == robot
    neutral = read_nirox(SourceText("slide.stp", write_nirox(robot).text))
    assert neutral.robot is not None, neutral.findings
    assert neutral.robot.drives == (DRIVE,)
    usual, _ = read(TEXT.replace("back_efficiency = 0.85\n", ""))
    assert usual is not None
    again = read_nirox(SourceText("slide.stp", write_nirox(usual).text))
    assert again.robot is not None
    assert again.robot.drives == usual.drives


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("lead = 0.01", "lead = 0", "`drives.lead` is 0"),
        ("lead = 0.01", "lead = 1e-300", "`drives.lead` is 1e-300, allowed is from 1e-05 m on"),
        ("lead = 0.01", "lead = 0.01\nratio = 5", "belong to two kinds of transmissions"),
        ("efficiency = 0.9\nback_efficiency = 0.85", "efficiency = 0.4", "back_efficiency"),
        ("efficiency = 0.9", "efficiency = 1.4", "efficiency"),
        ("lead = 0.01\n", "", "lead"),
        ('type = "prismatic", limits = [0, 500]', "limits = [0, 90]", "joint `1` turns"),
    ],
)
def test_impossible_screws_in_files_are_told(old: str, new: str, words: str) -> None:
    robot, messages = read(TEXT.replace(old, new, 1))
    assert robot is None
    assert any(words in one for one in messages), messages


def test_what_a_screw_loses_is_what_the_motor_gives_too_much() -> None:
    """Power at the shaft less power at the nut is never negative."""
    chain = chain_of(DRIVE)
    rates = slopes_of(slide())
    for speed in np.linspace(-0.3, 0.3, 13):
        for torque in (-5.0, 1.0, 5.0):
            force = rates(np.array([0.0, speed]), torque)[1] * MOVED
            assert torque * RATIO * speed - force * speed >= -1e-9
    assert chain.transmission.states == ()
