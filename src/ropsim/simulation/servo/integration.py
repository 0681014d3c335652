"""How drives and arm are integrated, and the error of it: a jolt of every axis with steps of two lengths."""

from math import ceil, floor, inf, isfinite, log10, nan

import numpy as np

from ropsim.core import RopsimError
from ropsim.flow import IntegrationFacts, JointReference
from ropsim.model import Payload, Rates
from ropsim.simulation.servo.plant_steps import fastest_pole, friction_rates, step_cause
from ropsim.simulation.servo.servo import Servo
from ropsim.simulation.servo.state import ServoState
from ropsim.spatial import Array

CLASSICAL, PROJECTED = "Runge-Kutta 4", "Runge-Kutta 4 with projection"
"""Names of the methods: with equal steps, and of closed chains with steps that are parted where needed."""

JOLT = 0.02
"""How long the axes are jolted [s]."""

_LEAST_TICKS = 4
_UNKNOWN_ACCELERATION = 10.0
"""Acceleration of an axis for which no limit is known [rad/s² | m/s²]."""

_HALVED = 16.0 / 15.0
"""Error of a method of fourth order over its difference from steps of half the length."""


def integration_facts(servo: Servo, rates: Rates, start: ServoState, payload: Payload) -> IntegrationFacts:
    """Return how a servo is integrated that starts in a state with a body at its mechanical interface.

    Args:
        servo: arm and controller.
        rates: of the controller.
        start: at rest on its reference, as `Servo.initial_state` returns it.
        payload: tool and part.
    """
    robot = servo.robot
    pole = float(f"{max(fastest_pole(robot), float(friction_rates(robot).rates.max())):.4g}")
    method = PROJECTED if robot.cuts else CLASSICAL
    error = integration_error(servo, start, payload)
    return IntegrationFacts(method, servo.period / servo.plant_steps, step_cause(robot, rates), pole, error)


def integration_error(servo: Servo, start: ServoState, payload: Payload) -> float:
    """Return by how much a coordinate is off at most by the integration [rad | m], rounded up to one digit.

    The reference leaves the start with the largest acceleration of each axis towards the middle of its range,
    and with the opposite one behind half of the time; between the two, and at both ends, it jumps, as no
    planned motion does. The same is integrated with steps of half the length; the greatest difference of a
    coordinate, times 16/15, is the error of a method of fourth order (E. Hairer, S. P. Norsett, G. Wanner:
    Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, section II.4). NaN under a law written
    in Python, which may keep something of its own from call to call, and where the jolt does not end well.
    """
    if servo.python_law is not None:
        return nan
    reference = jolt(servo, start.q)
    try:
        ways = [driven_way(one, start, reference, payload) for one in (servo, servo.with_shorter_steps(2))]
    except RopsimError:
        return nan
    return _rounded_up(_HALVED * float(np.abs(ways[0] - ways[1]).max()))


def driven_way(servo: Servo, start: ServoState, reference: JointReference, payload: Payload) -> Array:
    """Return the coordinates at the ticks of a reference, shape (ticks + 1, n)."""
    recorder, aux = servo.recorder(start), np.zeros((reference.ticks, len(servo.law.traits.aux)))
    servo.run(start, reference, payload, recorder, aux)
    return recorder.channels()["q"]


def jolt(servo: Servo, q: Array) -> JointReference:
    """Return the reference of the jolt of all axes from coordinates on [rad | m], shape (n,)."""
    robot, period = servo.robot, servo.period
    ticks = max(_LEAST_TICKS, ceil(JOLT / period))
    most = np.array([one.max_acceleration for one in robot.axis_joints])
    ends = np.array([(one.lower, one.upper) for one in robot.axis_joints])
    middle = np.where(np.isfinite(ends).all(axis=1), 0.5 * ends.sum(axis=1), inf)
    there = np.where(middle >= q, 1.0, -1.0)
    ahead = there * np.where(np.isfinite(most), most, _UNKNOWN_ACCELERATION)
    times = period * np.arange(1, ticks + 1)[:, np.newaxis]
    behind = np.maximum(times - 0.5 * ticks * period, 0.0)
    speeds = ahead * (times - 2.0 * behind)
    ways = ahead * (0.5 * times**2 - behind**2)
    return JointReference(q + ways, speeds, np.where(behind > 0.0, -ahead, ahead))


def _rounded_up(value: float) -> float:
    """Return the least number of one digit that is not below a value."""
    if not isfinite(value) or value == 0.0:
        return value
    digit = floor(log10(value))
    return float(f"{ceil(value / 10.0**digit)}e{digit}")
