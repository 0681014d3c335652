"""Loops of ball screws: the gain with which a simulation oscillates is the margin that is stated."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import JointReference
from ropsim.model import (
    BallScrew,
    ComputedTorqueGains,
    ControllerModel,
    Drive,
    EffortAmplifier,
    Friction,
    IdealMotor,
    Payload,
    Rates,
    RobotModel,
)
from ropsim.simulation import (
    ServoLoop,
    SimulationOptions,
    SlowMotion,
    linear_loop,
    margins,
    rest_of,
    simulate,
    slow_motions,
)
from ropsim.spatial import frozen

WEIGHT = 785.0
"""Of what is lifted [N]; it has 80 kg."""
AT = np.array([0.1])
SPEED = 0.1
"""Of the motions, twenty times that at which the losses turn round [m/s]."""
RATES = Rates(500, 4)
NOTHING = Payload()
EFFICIENCIES = [(1.0, 1.0), (0.7, 0.57), (0.5, 0.3)]


def lift(efficiency: float, back: float, effort: float = 50.0) -> RobotModel:
    """Return a vertical slide on a ball screw with a lead of 10 mm."""
    slide = robots.driven_slide((), robots.AxisData(-1.0, 1.0, 2.0, 10.0, 80.0))
    screw = BallScrew(0.01 / (2.0 * np.pi), efficiency, back)
    drive = Drive(EffortAmplifier(effort), IdealMotor(1e-4), screw, Friction(1e-4))
    return replace(slide, drives=(drive,), gravity=np.array([-WEIGHT / 80.0, 0.0, 0.0]))


def controller(robot: RobotModel, factor: float = 1.0) -> ControllerModel:
    found = robots.default_controller(robot, RATES)
    gains = found.gains
    assert isinstance(gains, ComputedTorqueGains)
    return replace(found, gains=replace(gains, kp=gains.kp * factor, kd=gains.kd * factor))


def stated(robot: RobotModel, way: float) -> float:
    """Return the gain margin in motion one way, 0 for the rest."""
    motion = SlowMotion("so", frozen(np.array([way * SPEED]))) if way else rest_of(robot)
    (loop,) = ServoLoop.of(robot, controller(robot)).about(AT, NOTHING, (motion,))
    return margins(loop, 0).gain


def swing(robot: RobotModel, factor: float, way: float) -> float:
    """Return how much the speed of a simulated motion goes up and down at its end [m/s]."""
    time = np.arange(1, 401) / RATES.control_hz
    share = np.clip(time / 0.2, 0.0, 1.0)
    qd = way * SPEED * share**2 * (3.0 - 2.0 * share)
    q = AT[0] + np.cumsum(qd) / RATES.control_hz
    rows = (q, qd, np.gradient(qd, 1.0 / RATES.control_hz))
    reference = JointReference(*(one[:, np.newaxis] for one in rows))
    recording = simulate(robot, controller(robot, factor), reference, SimulationOptions(start=AT))
    return float(np.std(recording.rows("qd")[-100:, 0]))


@pytest.mark.parametrize("way", [1.0, -1.0], ids=["lifting", "lowering"])
@pytest.mark.parametrize(("efficiency", "back"), EFFICIENCIES)
def test_a_simulated_motion_oscillates_at_the_stated_gain_margin(
    efficiency: float, back: float, way: float
) -> None:
    robot = lift(efficiency, back)
    most = stated(robot, way)
    assert swing(robot, 0.8 * most, way) < 2e-3 * SPEED
    assert swing(robot, 1.2 * most, way) > 2e-2 * SPEED


@pytest.mark.parametrize(("efficiency", "back"), EFFICIENCIES)
def test_threads_change_margins_by_their_efficiencies_in_motion_and_not_at_rest(
    efficiency: float, back: float
) -> None:
    lossless, screw = lift(1.0, 1.0), lift(efficiency, back)
    assert stated(screw, 0.0) == pytest.approx(stated(lossless, 0.0), rel=1e-6)
    assert stated(screw, 1.0) == pytest.approx(stated(lossless, 1.0) / efficiency, rel=1e-4)
    assert stated(screw, -1.0) == pytest.approx(stated(lossless, -1.0) * back, rel=1e-4)
    at_rest = linear_loop(screw, controller(screw), AT, NOTHING)
    assert margins(at_rest, 0).gain == pytest.approx(stated(lossless, 0.0), rel=1e-6)


def test_a_motor_that_cannot_lift_against_the_threads_has_no_loop_there() -> None:
    """The weight takes 1.25 N·m of the motor, 2.5 N·m where half of it is lost."""
    for effort, ways in ((2.6, {-1.0, 1.0}), (2.4, {-1.0}), (1.3, {-1.0})):
        found = slow_motions(lift(0.5, 0.3, effort), AT, NOTHING)
        assert {float(np.sign(one.qd[0])) for one in found} == ways
