"""Loops about slow motions: laws and valves that differ by direction, and what a law remembers on its way."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import CompiledLaw, LawInput, LawTraits, PythonLaw
from ropsim.dynamics import gravity, steady_drive
from ropsim.model import (
    ControllerKind,
    ControllerModel,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    HydraulicCylinder,
    IdealMotor,
    InputKind,
    Link,
    Payload,
    PiGains,
    Rates,
    RobotModel,
)
from ropsim.robots import controller_under
from ropsim.simulation import (
    LinearLoop,
    ServoLoop,
    SlowMotion,
    linear_loop,
    margins,
    motions_together,
    oil_springs,
    rest_of,
    slow_motions,
    slow_speeds,
)
from ropsim.spatial import Array
from support.hydraulic_arm import LOAD, SQUARES, angles, hydraulic_arm

INERTIA, HZ = 0.7, 2000
KP, KD = 900.0, 28.0
NOTHING, HELD = Payload(), np.zeros(1)
ONE_WAY = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        factor = par[2, j] if meas[1, j] < 0.0 else 1.0
        out[j] = factor * (par[0, j] * (ref[0, j] - meas[0, j]) + par[1, j] * (ref[1, j] - meas[1, j]))
"""
BY_DIFFERENCES = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        way = meas[0, j] - state[0, j]
        state[0, j] = meas[0, j]
        factor = par[2, j] if way < 0.0 else 1.0
        out[j] = factor * (par[0, j] * (ref[0, j] - meas[0, j]) + par[1, j] * (ref[1, j] - meas[1, j]))
"""
LAGGING = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        error = par[0, j] * (ref[0, j] - meas[0, j]) - meas[1, j]
        u = par[1, j] * error + state[0, j]
        if abs(u) < par[3, j]:
            state[0, j] += par[2, j] * error / HZ
        out[j] = u
""".replace("HZ", repr(float(HZ)))
FACTOR = 3.0


class OneWay:
    """The law of `ONE_WAY` as a Python object."""

    traits = LawTraits(InputKind.EFFORT)

    def step(self, now: LawInput, state: Array) -> Array:
        """Return the efforts."""
        del state
        factor = np.where(now.meas[1] < 0.0, FACTOR, 1.0)
        return np.asarray(factor * (KP * (now.ref[0] - now.meas[0]) + KD * (now.ref[1] - now.meas[1])))


def wheel() -> RobotModel:
    """Return an inertia on a motor without friction, about a vertical axis."""
    arm = robots.load("two_link")
    drive = Drive(EffortAmplifier(), IdealMotor(), Gear())
    link = Link(0.0, np.zeros(3), INERTIA * np.eye(3))
    one = replace(arm, joints=arm.joints[:1], links=(link,), drives=(drive,), home=HELD)
    return replace(one, axes=(0,), tip=0)


def model() -> ControllerModel:
    return replace(robots.default_controller(wheel(), Rates(HZ, 4)), rates=Rates(HZ, 4))


def compiled(source: str, *rows: float, states: tuple[str, ...] = ()) -> CompiledLaw:
    traits = LawTraits(InputKind.EFFORT, state_names=states)
    names = tuple(f"p{k}" for k in range(len(rows)))
    return CompiledLaw("own", source, names, np.array(rows)[:, np.newaxis], traits)


def loops(law: CompiledLaw | PythonLaw) -> tuple[LinearLoop, ...]:
    """Return the loops of the wheel at rest, forward and back."""
    motions = (rest_of(wheel()), *motions_together(slow_speeds(wheel(), HELD, NOTHING)))
    assert [one.words for one in motions] == ["at rest", "forward", "back"]
    return ServoLoop.of(wheel(), model(), law).about(HELD, NOTHING, motions)


@pytest.mark.parametrize(
    "law",
    [
        compiled(ONE_WAY, KP, KD, FACTOR),
        compiled(BY_DIFFERENCES, KP, KD, FACTOR, states=("before",)),
        OneWay(),
    ],
    ids=["compiled", "speed from coordinates", "python"],
)
def test_a_law_with_another_gain_for_either_direction_has_the_margins_of_both(
    law: CompiledLaw | PythonLaw,
) -> None:
    _, forward, back = (margins(one, 0) for one in loops(law))
    for found, factor in ((forward, 1.0), (back, FACTOR)):
        plain = compiled(ONE_WAY, factor * KP, factor * KD, 1.0)
        expected = margins(linear_loop(wheel(), model(), HELD, NOTHING, plain), 0)
        assert found.phase == pytest.approx(expected.phase, rel=1e-6)
        assert found.gain == pytest.approx(expected.gain, rel=1e-6)
        assert found.sensitivity == pytest.approx(expected.sensitivity, rel=1e-6)
    assert forward.gain == pytest.approx(FACTOR * back.gain, rel=1e-6)


def test_a_law_that_lags_keeps_its_integral_in_motion() -> None:
    """Nothing fed forward: with the arm on its reference the integral would run to its limit and stand."""
    speed = float(slow_speeds(wheel(), HELD, NOTHING)[0])
    rest, *moving = loops(compiled(LAGGING, 12.0, 30.0, 90.0, 0.5 * 30.0 * speed, states=("integral",)))
    assert rest.L[0].any()
    for one in moving:
        for name in ("F", "G", "K", "L"):
            np.testing.assert_allclose(getattr(one, name), getattr(rest, name), rtol=1e-6, atol=1e-9)


def test_an_arm_with_linear_drives_has_the_same_loops_in_slow_motion() -> None:
    robot, controller = robots.load("puma560"), robots.default_controller("puma560")
    servo, motions = ServoLoop.of(robot, controller), slow_motions(robot, robots.load("puma560").home, LOAD)
    words = {one.words for one in motions}
    assert {"all forward", "joint 1 back", "joint 6 forward", "tool +z"} <= words
    (rest,) = servo.about(robot.home, LOAD, (rest_of(robot),))
    for motion in (motions[0], motions[-1]):
        (moving,) = servo.about(robot.home, LOAD, (motion,))
        for axis in range(robot.n):
            assert margins(moving, axis).gain == pytest.approx(margins(rest, axis).gain, rel=0.01)


def test_a_loop_has_the_gain_of_its_valve_in_the_direction_of_motion() -> None:
    """Of a P loop, where it is slower than its oil: kp·v/ω, with the speed v over the input of the valve."""
    crane = robots.load("patu655")
    drives = []
    for drive in crane.drives:
        assert isinstance(drive.motor, HydraulicCylinder)
        drives.append(replace(drive, motor=replace(drive.motor, leakage=0.0), friction=Friction()))
    arm, q = replace(crane, drives=tuple(drives)), np.radians([45.0, -60.0])
    gains = PiGains(np.full(2, 0.01), np.zeros(2))
    controller = replace(controller_under(crane, Rates(), ControllerKind.PARALLEL_PI), gains=gains)
    servo, hz = ServoLoop.of(arm, controller), 0.5
    z = np.exp(2j * math.pi * hz * controller.rates.control_period)
    for one in oil_springs(arm, q, NOTHING):
        motor = arm.drives[one.axis].motor
        assert isinstance(motor, HydraulicCylinder)
        for sign, steady in ((1.0, one.forward), (-1.0, one.back)):
            qd = np.zeros(2)
            qd[one.axis] = sign * 0.01 * arm.max_speeds[one.axis]
            (loop,) = servo.about(q, NOTHING, (SlowMotion("own", qd),))
            A, b, c = loop.broken(one.axis)
            opened = abs(c @ np.linalg.solve(z * np.eye(len(A)) - A, b))
            expected = 0.01 * steady / motor.rated_input / (2.0 * math.pi * hz)
            assert opened == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize(
    ("kind", "gain", "sensitivity"),
    [(ControllerKind.FLOW_LOAD_DAMPING, 8.0, 1.3), (ControllerKind.PARALLEL_PI, 2.4, 1.7)],
)
def test_the_four_squares_have_their_margins_at_rest_and_in_slow_motion(
    kind: ControllerKind, gain: float, sensitivity: float
) -> None:
    robot = hydraulic_arm()
    servo = ServoLoop.of(robot, controller_under(robot, Rates(), kind))
    for corner in SQUARES.values():
        q = angles(np.array(corner) + 0.05)
        motions = (rest_of(robot), *slow_motions(robot, q, LOAD))
        assert len(motions) == 13
        for loop in servo.about(q, LOAD, motions):
            for axis in range(2):
                found = margins(loop, axis)
                assert found.gain > gain
                assert found.sensitivity < sensitivity


def test_rods_go_faster_than_they_leak() -> None:
    robot = hydraulic_arm()
    for corner in SQUARES.values():
        q = angles(np.array(corner))
        rows = zip(
            robot.drives, q.tolist(), slow_speeds(robot, q, LOAD), gravity(robot, q, LOAD), strict=True
        )
        for drive, place, speed, weight in rows:
            motor = drive.motor
            assert isinstance(motor, HydraulicCylinder)
            a, b = steady_drive(drive, place, 0.0, float(weight)).states[:2]
            rod = abs(drive.ratio_at(place)) * speed
            assert rod * min(motor.area_a, motor.area_b) > 1.99 * motor.leakage * abs(a - b)
            assert rod * max(motor.area_a, motor.area_b) > 0.0499 * motor.rated_flow
