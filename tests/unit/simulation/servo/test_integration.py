"""The integration of drives and arm says its step, what set it, and its error."""

import math

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import StepCause
from ropsim.model import (
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
from ropsim.simulation import Servo, SimulationOptions, simulate
from ropsim.simulation.testing import (
    CLASSICAL,
    JOLT,
    MOST,
    driven_way,
    integration_error,
    integration_facts,
    jolt,
    long_step,
    plant_steps_of,
    step_cause,
)
from support.arms import one_axis
from support.servo_cases import START, CascadeInPython, puma, standing

LINK = 0.6


def swinging(stiffness: float = 4e3, motor: float = 1e-4) -> RobotModel:
    """Return an axis on a spring without friction; `fastest_pole` has its closed form."""
    return one_axis(Drive(EffortAmplifier(), IdealMotor(motor), ElasticGear(50.0, stiffness)), LINK)


def error_of(robot: RobotModel, steps: int) -> float:
    rates = Rates(1000, plant_steps=steps)
    servo = Servo.build(robot, robots.cascaded_controller(robot, rates))
    return integration_error(servo, servo.initial_state(robot.home), Payload())


def test_the_error_is_that_against_steps_many_times_shorter() -> None:
    """Rounded up to one digit, it is at most a digit more."""
    robot, controller = puma()
    servo = Servo.build(robot, controller)
    start = servo.initial_state(START)
    stated = integration_error(servo, start, Payload())
    reference = jolt(servo, START)
    fine = driven_way(servo.with_shorter_steps(16), start, reference, Payload())
    true = float(np.abs(driven_way(servo, start, reference, Payload()) - fine).max())
    assert len(reference.q) == JOLT * servo.control_hz
    assert 0.9 * true <= stated <= 2.2 * true


def test_half_the_step_has_a_sixteenth_of_the_error() -> None:
    """A method of fourth order; one digit of the error is kept."""
    coarse, fine = error_of(swinging(), 1), error_of(swinging(), 2)
    assert 7.0 < coarse / fine < 34.0


@pytest.mark.parametrize(
    ("name", "rates", "cause"),
    [
        ("puma560", Rates(), StepCause.LONGEST),
        ("puma560", Rates(100), StepCause.LONGEST),
        ("manutec_r3", Rates(), StepCause.POLE),
        ("puma560", Rates(plant_steps=4), StepCause.STATED),
    ],
)
def test_the_cause_of_the_steps_is_named(name: str, rates: Rates, cause: StepCause) -> None:
    assert step_cause(robots.load(name), rates) is cause


def test_friction_and_the_most_steps_are_causes_too() -> None:
    light = one_axis(Drive(EffortAmplifier(), IdealMotor(), Gear(1.0), Friction(viscous=5.0)), 1e-7)
    assert step_cause(light, Rates()) is StepCause.MOST
    under_load = Drive(EffortAmplifier(100.0), IdealMotor(), Gear(1.0), LoadFriction(0.0, 1.0, 0.2, 0.1))
    assert step_cause(one_axis(under_load, 0.02), Rates()) is StepCause.FRICTION


def test_a_recording_says_how_it_was_integrated() -> None:
    robot, controller = puma()
    found = simulate(robot, controller, standing(START, 8), SimulationOptions()).facts.stations[0]
    assert found.integration is not None
    assert found.plant_steps == 2
    assert (found.integration.method, found.integration.step) == (CLASSICAL, 5e-4)
    assert found.integration.pole == pytest.approx(2428.0, rel=1e-3)
    assert 0.0 < found.integration.error < 1e-6


def test_a_law_in_python_is_not_called_for_it() -> None:
    robot, controller = puma()
    law = CascadeInPython(controller, robot)
    servo = Servo.build(robot, controller, law)
    facts = integration_facts(servo, Rates(), servo.initial_state(START), Payload())
    assert math.isnan(facts.error)


def test_steps_that_are_too_long_for_a_pole_are_found_and_the_hint_mends_it() -> None:
    robot = swinging(stiffness=4e6)
    pole = math.sqrt(4e6 * (1.0 / (1e-4 * 50.0**2) + 1.0 / LINK))
    found = long_step("robot", robot, Rates(plant_steps=1))
    assert found is not None
    assert found.data["pole"] == pytest.approx(pole, rel=1e-6)
    needed = math.ceil(1e-3 * pole / 2.0)
    assert found.hint == f"`plant_steps` = {needed} would do"
    assert long_step("robot", robot, Rates(plant_steps=needed)) is None
    assert long_step("robot", robot, Rates()) is None


def test_what_needs_more_than_the_most_steps_is_found() -> None:
    robot = swinging(stiffness=4e10)
    found = long_step("robot", robot, Rates())
    assert found is not None
    assert f"step of {1.0 / MOST:.3g} ms" in found.message


@pytest.mark.parametrize("name", [one for one in robots.names() if robots.load(one).drives])
def test_no_arm_of_the_library_needs_more_than_three_steps_of_a_millisecond(name: str) -> None:
    """So no method for stiff equations is at hand: that would cost more than such steps do."""
    assert plant_steps_of(robots.load(name), Rates(1000)) <= 3
