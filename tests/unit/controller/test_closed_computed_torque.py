"""Computed torque of arms with closed chains: inverse dynamics of the axes, and small errors on a motion."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, law_of
from ropsim.dynamics import barycentric, closed_coordinates, inverse_dynamics
from ropsim.flow import JointReference
from ropsim.model import (
    ControllerKind,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    IdealMotor,
    Payload,
    Rates,
    RobotModel,
)
from ropsim.robots import controller_under, possible_laws
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.closed_arms import COUPLED_PALLETIZER, delta, five_bar, palletizer
from support.servo_cases import quintic

RATES = Rates(1000)
TORQUE, FIXED = ControllerKind.COMPUTED_TORQUE, ControllerKind.CASCADED_P_PI
LOAD = Payload(2.0, np.array([0.02, -0.01, 0.05]), 0.01 * np.eye(3))
GEARED = COUPLED_PALLETIZER.drives[1]
DIRECT = Drive(EffortAmplifier(), IdealMotor(0.02), Gear(10.0), Friction(1e-3, 0.01, -0.01))
AWAY = 2e-3
"""What chains move in a control tick at some radians a second [rad]."""


def driven(robot: RobotModel, drive: Drive = GEARED) -> RobotModel:
    return replace(robot, drives=(drive,) * robot.n)


def output(robot: RobotModel, ref: Array, meas: Array, chains: Array) -> tuple[Array, Array]:
    """Return what the law puts out, evaluated in plain Python, and the chains that it remembers then."""
    law = law_of(controller_under(robot, RATES, TORQUE), robot)
    assert isinstance(law, CompiledLaw)
    scope: dict[str, Any] = {"math": math, "np": np}
    for one in (*(function.text for function in law.functions), law.source):
        exec(one, scope)
    n, row = robot.n, law.traits.chain_row
    assert row == 1
    state, out = np.zeros((len(law.traits.state_names), n)), np.zeros(n)
    state.reshape(-1)[n : n + len(chains)] = chains
    load = barycentric(LOAD.mass, LOAD.com, LOAD.inertia)
    scope["law"](law.parameters, state, ref, meas, load, np.zeros(0), out)
    return out, state.reshape(-1)[n : n + len(chains)]


@pytest.mark.parametrize("make", [five_bar, pytest.param(delta, marks=pytest.mark.slow)])
def test_the_output_is_the_inverse_dynamics_of_the_wanted_acceleration(
    make: Callable[[], RobotModel],
) -> None:
    """At a motor of ratio 10, with chains remembered from the tick before."""
    robot = driven(make(), DIRECT)
    random = np.random.default_rng(1)
    for _ in range(3):
        q = robot.home + random.uniform(-0.3, 0.3, robot.n)
        qd, qdd = random.uniform(-1.0, 1.0, (2, robot.n))
        chains = closed_coordinates(robot, q)
        before = chains + random.uniform(-AWAY, AWAY, len(chains))
        out, remembered = output(robot, np.array([q, qd, qdd]), np.array([q, qd, 0.0 * q]), before)
        np.testing.assert_allclose(remembered, chains, atol=1e-11)
        expected = inverse_dynamics(robot, q, qd, qdd, payload=LOAD)
        np.testing.assert_allclose(10.0 * out, expected, rtol=1e-9, atol=1e-9)


def largest_error(robot: RobotModel, kind: ControllerKind, believed: RobotModel | None = None) -> float:
    """Return the largest following error of a motion within a second [rad], under a law that knows an arm."""
    controller = controller_under(robot, RATES, kind)
    law = law_of(controller_under(believed, RATES, kind), believed) if believed else None
    servo = Servo.build(robot, controller, law)
    way = 0.15 * np.array([1.0, -1.0, 0.7, 1.0])[: robot.n]
    state = servo.initial_state(robot.home, LOAD)
    recorder = servo.recorder(state)
    servo.run(state, quintic(robot.home, robot.home + way, 1000), LOAD, recorder)
    channels = recorder.channels()
    return float(np.abs(channels["q_ref"] - channels["q"]).max())


def heavier(robot: RobotModel, share: float) -> RobotModel:
    links = tuple(replace(one, mass=share * one.mass, inertia=share * one.inertia) for one in robot.links)
    return replace(robot, links=links)


@pytest.mark.parametrize(
    "make",
    [five_bar, palletizer, pytest.param(delta, marks=pytest.mark.slow)],
    ids=lambda make: make.__name__,
)
def test_the_error_on_a_motion_is_far_below_that_of_fixed_gains(make: Callable[[], RobotModel]) -> None:
    robot = make()
    robot = robot if robot.drives else driven(robot)
    assert largest_error(robot, TORQUE) < 0.1 * largest_error(robot, FIXED)


@pytest.mark.parametrize("share", [0.8, 1.2])
def test_the_error_is_no_larger_with_wrong_masses(share: float) -> None:
    robot = driven(five_bar())
    assert largest_error(robot, TORQUE, heavier(robot, share)) < largest_error(robot, FIXED)


def test_plain_python_follows_as_compiled_code_does() -> None:
    robot = driven(five_bar())
    controller = controller_under(robot, RATES, TORQUE)
    ends = []
    for engine in (None, Engine.PYTHON):
        servo = Servo.build(robot, controller, engine=engine)
        state = servo.initial_state(robot.home, LOAD)
        motion = JointReference(
            *(np.tile(one, (3, 1)) for one in (robot.home + 0.01, 0.0 * robot.home, 0.0 * robot.home))
        )
        ends.append(servo.run(state, motion, LOAD, servo.recorder(state)).values)
    np.testing.assert_allclose(ends[0], ends[1], atol=1e-9)


def test_closed_chains_have_computed_torque_first_but_with_elastic_gears() -> None:
    soft = Drive(GEARED.amplifier, GEARED.motor, ElasticGear(100.0, 1e5), GEARED.friction)
    assert possible_laws(driven(five_bar())) == (TORQUE, FIXED)
    assert possible_laws(palletizer()) == (TORQUE, FIXED)
    assert possible_laws(driven(five_bar(), soft)) == (FIXED,)
