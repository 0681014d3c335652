"""Dead centres under a controller: a chain that goes over ends the run, one that stays as it was goes on."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.controller import CompiledLaw
from ropsim.flow import JointReference
from ropsim.kinematics import dead_centre, is_as_at_home
from ropsim.model import (
    ControllerKind,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    LoopCut,
    Payload,
    Rates,
    RobotModel,
)
from ropsim.robots.standard_controller import controller_under
from ropsim.simulation import DivergedError, Servo, ServoState
from support.loops import IN_PLANE, at, joint, mechanism, rod

GROUND, CRANK, COUPLER, ROCKER = 0.9, 0.2, 0.8, 0.6
OUTER = np.pi - np.arccos((GROUND**2 + ROCKER**2 - (CRANK + COUPLER) ** 2) / (2.0 * GROUND * ROCKER))
"""Angle of the rocker where crank and coupler are in one line, by the law of cosines [rad]."""
MOTOR = Drive(EffortAmplifier(500.0), IdealMotor(0.05), Gear(1.0), Friction(0.5))
RATES = Rates(1000)


def four_bar(axis: int) -> RobotModel:
    """Return a crank and rocker in a horizontal plane, with the motor at the crank (0) or the rocker (2)."""
    joints = (joint("crank", at(0.0)), joint("coupler", at(CRANK), 0), joint("rocker", at(GROUND)))
    links = (rod(1.0, CRANK), rod(1.0, COUPLER), rod(2.0, ROCKER))
    cut = LoopCut(1, at(COUPLER), 2, at(ROCKER), IN_PLANE)
    made = mechanism(joints, links, (cut,), 0.6, np.zeros(3))
    if axis == 2:
        made = replace(made, axes=(2,), home=np.array([2.1]))
    return replace(made, drives=(MOTOR,))


def parallelogram() -> RobotModel:
    joints = (joint("left", at(0.0)), joint("right", at(0.5)), joint("top", at(0.3), 0))
    cut = LoopCut(2, at(0.5), 1, at(0.3), IN_PLANE)
    made = mechanism(joints, (rod(1.0, 0.3), rod(1.0, 0.3), rod(1.0, 0.5)), (cut,), 1.0, np.zeros(3))
    return replace(made, drives=(MOTOR,))


def sweep(start: float, end: float, ticks: int) -> JointReference:
    """Return a motion from rest to rest along a cosine."""
    phase = np.pi * np.arange(1, ticks + 1)[:, np.newaxis] / ticks
    way, rate = end - start, np.pi * RATES.control_hz / ticks
    half = 0.5 * way
    return JointReference(
        start + half * (1.0 - np.cos(phase)), half * rate * np.sin(phase), half * rate**2 * np.cos(phase)
    )


SPRING_AND_DAMPER = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = par[0, j] * (ref[0, j] - meas[0, j]) + par[1, j] * (ref[1, j] - meas[1, j])
"""


LAW = CompiledLaw("spring", SPRING_AND_DAMPER, ("stiffness", "damping"), np.array([[200.0], [20.0]]))


def driven(robot: RobotModel, reference: JointReference, slices: int = 1) -> ServoState:
    controller = controller_under(robot, RATES, ControllerKind.CASCADED_P_PI)
    servo = Servo.build(robot, controller, LAW)
    state = servo.initial_state(robot.home)
    size = reference.ticks // slices
    for k in range(slices):
        part = reference.part(k * size, (k + 1) * size)
        state = servo.run(state, part, Payload(), servo.recorder(state))
    return state


def tick(caught: pytest.ExceptionInfo[DivergedError]) -> int:
    found = caught.value.diagnostic.data["tick"]
    assert isinstance(found, int)
    return found


def test_a_rocker_that_is_driven_beyond_its_dead_centre_ends_the_run() -> None:
    """A rocker does not turn a crank through the line of crank and coupler: the crank goes over."""
    with pytest.raises(DivergedError) as caught:
        driven(four_bar(2), sweep(2.1, 1.6, 500))
    found = caught.value.diagnostic
    assert found.code == "S709"
    assert found.data["axis"] == "rocker"
    assert found.data["joint"] in {"crank", "coupler"}
    assert found.data["chain"] == 1
    assert found.data["q"] == pytest.approx(OUTER, abs=1e-3)
    assert 200 < tick(caught) < 500


def test_the_tick_does_not_depend_on_the_slices() -> None:
    times = []
    for slices in (1, 125):
        with pytest.raises(DivergedError) as caught:
            driven(four_bar(2), sweep(2.1, 1.6, 500), slices)
        times.append(tick(caught))
    assert times[0] == times[1]


def test_a_rocker_that_stays_off_its_dead_centre_goes_on() -> None:
    end = driven(four_bar(2), sweep(2.1, OUTER + 0.02, 500))
    assert end.q[0] == pytest.approx(OUTER + 0.02, abs=0.03)


def test_a_crank_passes_the_dead_centres_of_its_rocker() -> None:
    end = driven(four_bar(0), sweep(0.6, 7.0, 1000))
    assert end.q[0] == pytest.approx(7.0, abs=0.05)


def test_a_parallelogram_that_is_stretched_opens_as_one() -> None:
    """It is simulated as a coupling, which has no other assembly."""
    robot = parallelogram()
    servo_end = driven(robot, sweep(1.0, -1.0, 1000))
    assert servo_end.q[0] == pytest.approx(-1.0, abs=0.02)
    assert servo_end.layout.passive == 0


def test_an_anti_parallelogram_is_another_assembly() -> None:
    """Its coupler is that of the parallelogram, mirrored at the diagonal from left pin to right foot."""
    robot, bar, base, left = parallelogram(), 0.3, 0.5, 0.4
    pin, foot = bar * np.array([np.cos(left), np.sin(left)]), np.array([base, 0.0])
    along = (foot - pin) / np.linalg.norm(foot - pin)
    coupler = 2.0 * base * along[0] * along - np.array([base, 0.0])
    end = pin + coupler - foot
    assert np.linalg.norm(end) == pytest.approx(bar)
    right, top = np.arctan2(end[1], end[0]), np.arctan2(coupler[1], coupler[0]) - left
    assert not is_as_at_home(robot, np.array([left, right, top]))
    assert is_as_at_home(robot, np.array([left, left, -left]))


def test_the_held_axis_and_the_free_joint_of_a_dead_centre() -> None:
    """Crank and coupler in one line: the rocker is held, and both others turn while it stands."""
    inner = np.arccos((GROUND**2 + (CRANK + COUPLER) ** 2 - ROCKER**2) / (2.0 * GROUND * (CRANK + COUPLER)))
    found = dead_centre(four_bar(2), np.array([OUTER, inner, 0.0]))
    assert (found.chain, found.axis) == (0, 0)
    assert found.joint in {0, 1}
    assert found.distance < 1e-12
