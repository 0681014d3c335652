"""Integration steps follow from the fastest pole of drives and arm."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine, load
from ropsim.controller import LawTraits
from ropsim.dynamics import arm_numbers, structure_of
from ropsim.model import (
    BacklashGear,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    IdealMotor,
    LoadFriction,
    Payload,
    Rates,
    RobotModel,
)
from ropsim.simulation import DivergedError, Servo
from ropsim.simulation.servo.plant_code import plant_code
from ropsim.simulation.servo.plant_steps import LARGEST_PRODUCT, MOST, fastest_pole, plant_steps_of
from ropsim.simulation.servo.state import StateLayout
from ropsim.simulation.servo.stiffness import steep_axes
from ropsim.spatial import Array
from support.arms import one_axis
from support.servo_cases import GOAL, START, quintic


def test_the_pole_of_a_motor_on_a_spring_is_that_of_two_masses() -> None:
    """Motor J·G² and link M on a spring k swing with sqrt(k·(1/(J·G²) + 1/M))."""
    motor, ratio, stiffness, link = 1e-4, 50.0, 4e3, 0.6
    drive = Drive(EffortAmplifier(), IdealMotor(motor), ElasticGear(ratio, stiffness))
    expected = math.sqrt(stiffness * (1.0 / (motor * ratio**2) + 1.0 / link))
    assert fastest_pole(one_axis(drive, link)) == pytest.approx(expected, rel=1e-6)


def test_the_pole_of_viscous_friction_is_its_slope_over_the_inertia() -> None:
    drive = Drive(EffortAmplifier(), IdealMotor(2e-4), Gear(10.0), Friction(viscous=0.3))
    assert fastest_pole(one_axis(drive, 0.5)) == pytest.approx(0.3 * 100.0 / (0.5 + 2e-4 * 100.0), rel=1e-6)


@pytest.mark.parametrize("name", [one for one in robots.names() if robots.load(one).drives])
def test_no_pole_of_the_whole_plant_at_home_is_faster(name: str) -> None:
    """The Jacobian of all rates, mass matrix and gravity included, by differences about a state at rest."""
    robot = robots.load(name)
    code, n = plant_code(structure_of(robot)), robot.n
    functions = {one.name: one for one in code.functions}
    derivative = load("derivative", (functions["derivative"],), Engine.PYTHON)
    constants = code.constants(arm_numbers(robot))
    layout = StateLayout.of(structure_of(robot), LawTraits())
    start = at_home(robot, layout)
    jacobian = np.zeros((len(start), len(start)))
    for place, value in enumerate(start):
        step, sides = 1e-6 * max(1.0, abs(value)), []
        for sign in (1.0, -1.0):
            x, rates = start.copy(), np.empty(len(start))
            x[place] += sign * step
            derivative(x, np.zeros(n), constants, rates)
            sides.append(rates)
        jacobian[:, place] = (sides[0] - sides[1]) / (2.0 * step)
    assert np.abs(np.linalg.eigvals(jacobian)).max() <= 1.02 * fastest_pole(robot) + 10.0


def at_home(robot: RobotModel, layout: StateLayout) -> Array:
    """Return the state of an arm at home with all states of its drives at 0."""
    start = np.zeros(layout.integrated)
    start[: robot.n] = robot.home
    return start


def test_steps_are_short_and_keep_the_fastest_pole_stable() -> None:
    puma, r3 = robots.load("puma560"), robots.load("manutec_r3")
    assert [plant_steps_of(puma, Rates(hz)) for hz in (50, 100, 200, 1000, 4000)] == [40, 20, 10, 2, 1]
    assert plant_steps_of(r3, Rates(1000)) == math.ceil(1e-3 * fastest_pole(r3) / LARGEST_PRODUCT) == 3
    assert plant_steps_of(puma, Rates(1000, plant_steps=1)) == 1  # as stated


def test_a_light_link_with_much_friction_gets_at_most_so_many_steps() -> None:
    drive = Drive(EffortAmplifier(), IdealMotor(), Gear(1.0), Friction(viscous=5.0))
    assert plant_steps_of(one_axis(drive, 1e-7), Rates(1000)) == MOST


@pytest.mark.parametrize("hz", [50, 200])
def test_a_slow_controller_moves_a_puma(hz: int) -> None:
    """With two steps in a tick of 5 to 20 ms its motors would diverge within a tenth of a second."""
    robot, ends = robots.load("puma560"), list[Array]()
    needed = plant_steps_of(robot, Rates(hz))
    for steps in (None, 4 * needed):
        servo = Servo.build(robot, robots.default_controller(robot, Rates(hz, 1, steps)))
        start = servo.initial_state(START)
        end = servo.run(start, quintic(START, GOAL, 2 * hz), Payload(), servo.recorder(start))
        ends.append(end.values[: 2 * robot.n])
    np.testing.assert_allclose(ends[0], ends[1], atol=1e-6)
    two = Servo.build(robot, robots.default_controller(robot, Rates(hz, 1, 2)))
    start, reference = two.initial_state(START), quintic(START, GOAL, 2 * hz)
    with pytest.raises(DivergedError):
        two.run(start, reference, Payload(), two.recorder(start))


def test_a_gear_with_play_has_the_pole_of_its_flanks() -> None:
    """In the middle of its play an axis without load feels no spring; it leaves that at once."""
    motor, ratio, stiffness, link = 1e-4, 50.0, 4e6, 0.6
    gears = ElasticGear(ratio, stiffness, 30.0), BacklashGear(ratio, stiffness, 30.0, 3e-4)
    poles = [
        fastest_pole(one_axis(Drive(EffortAmplifier(), IdealMotor(motor), gear), link)) for gear in gears
    ]
    assert poles[0] == poles[1] > 4000.0


def test_friction_under_the_largest_load_is_stable_by_itself() -> None:
    """About a rest it is that of the held load; `S705` judges the largest effort."""
    arm = robots.load("irb120")
    drives = [
        replace(one, friction=LoadFriction(one.friction.viscous, one.friction.coulomb_positive, 0.15))
        for one in arm.drives
    ]
    assert steep_axes(replace(arm, drives=tuple(drives)), Rates()) == ()
