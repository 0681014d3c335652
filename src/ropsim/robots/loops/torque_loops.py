"""Loops of computed torque: their gains do not depend on posture and load, which the law knows.

Motors, control rate and elastic gears bound them. With the inertia M of all that moves, held by the rotor J
alone beyond the frequency at which the arm swings on an elastic gear, such a loop gets M/J times as fast.
"""

from functools import lru_cache

import numpy as np

from ropsim.dynamics import axis_inertias, chain_of, elastic_axes, rotor_inertias
from ropsim.kinematics import configurations
from ropsim.model import ComputedTorqueGains, Mechanism, Rates, RobotModel, with_payload
from ropsim.robots.loops.cascaded_loops import CONTROL_SHARE, ELECTRICAL_SHARE, POSITION_SHARE
from ropsim.robots.loops.elastic_gears import ELASTIC_SHARE, elastic_frequencies, elastic_words, span
from ropsim.spatial import Array, frozen

ROTOR_SHARE = 1.0 / 2.0
"""The same as `CONTROL_SHARE`, of a rotor on its elastic gear."""

INTEGRAL_SHARE = 0.3
"""Corner of the integral action over the crossover of the speed loop: it costs about 17 degrees."""

SAMPLES = 512
"""Configurations at which an arm with elastic gears is evaluated."""


def standard_torque_gains(robot: Mechanism, rates: Rates) -> ComputedTorqueGains:
    """Return the gains of computed torque for an arm with drives.

    With the crossover ω_s of the speed loop of an axis, kd = ω_s, kp = 0.3·ω_s², ki = 0.3·ω_s.
    """
    speed = _crossovers(robot, rates)
    return ComputedTorqueGains(kp=POSITION_SHARE * speed**2, kd=speed, ki=INTEGRAL_SHARE * speed)


def torque_statement(robot: Mechanism, rates: Rates) -> str:
    """Return how the gains come about."""
    speed = _crossovers(robot, rates)
    return (
        f"computed torque with the masses of the model, tool and part: speed loops {span(speed)} rad/s, "
        f"position loops {span(POSITION_SHARE * speed)} rad/s, integral action "
        f"{span(INTEGRAL_SHARE * speed)} rad/s, by motors and control rate"
        f"{elastic_words(_elastic(robot)[0])}"
    )


def _crossovers(robot: Mechanism, rates: Rates) -> Array:
    poles = np.array([chain_of(drive).motor.pole(drive.motor) for drive in robot.drives])
    swings, shares = _elastic(robot)
    bounds = (ELECTRICAL_SHARE * poles, ELASTIC_SHARE * swings, ROTOR_SHARE * rates.control_hz * shares)
    return np.asarray(np.minimum(np.min(bounds, axis=0), CONTROL_SHARE * rates.control_hz))


@lru_cache(maxsize=16)
def _elastic(robot: Mechanism) -> tuple[Array, Array]:
    """Return how fast each axis swings [rad/s], and the least share of its rotor in the inertia of the axis.

    With the rated load, where that is known. Both are inf for rigid gears.
    """
    axes, none = elastic_axes(robot), np.full(robot.n, np.inf)
    if not axes.any():
        return frozen(none), frozen(none)
    loaded = with_payload(robot, robot.rated_payload) if isinstance(robot, RobotModel) else robot
    Q = configurations(loaded, SAMPLES)
    shares = (rotor_inertias(loaded, Q) / axis_inertias(loaded, Q)).min(axis=0)
    return frozen(elastic_frequencies(loaded, Q)), frozen(np.where(axes, shares, np.inf))
