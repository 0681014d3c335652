"""Gains from a bandwidth and a damping ratio, for each law that has them.

An axis under one of the laws is a mass between a spring and a damper, s² + 2·ζ·ω·s + ω²: computed torque has
kp = ω² and kd = 2·ζ·ω, a cascade the crossover 2·ζ·ω of its speed loop and kp = ω/(2·ζ). Integral action
stands to the crossover as in the standard gains, which have ζ = 0.91. A hydraulic axis has a crossover alone:
its damping comes from leakage, or by the law of flow, load and damping from the force. All else of such laws
stands to the crossover as in the gains of their rules (`hydraulic_gains`): that of one axis over another,
corners, damping of the oil, and the share of its swing to which an axis is bound.
"""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ropsim.model import (
    CascadedGains,
    ComputedTorqueGains,
    ControllerModel,
    FlowGains,
    Gains,
    Mechanism,
    PiGains,
    Rates,
    gain_names,
)
from ropsim.robots.loops.cascaded_loops import (
    INTEGRAL_SHARE,
    POSITION_SHARE,
    LoopBandwidths,
    cascaded_gains,
)
from ropsim.robots.loops.hydraulic_gains import CORNER, INTEGRAL, flow_gains, parallel_pi_gains
from ropsim.robots.loops.hydraulic_loops import CORNER_SHARE, hydraulic_axes, with_hydraulic_axes
from ropsim.robots.loops.torque_loops import INTEGRAL_SHARE as TORQUE_SHARE
from ropsim.spatial import Array

STANDARD_DAMPING = 0.5 * POSITION_SHARE**-0.5
"""Damping ratio of the standard gains."""
_DIGITS = 4
"""Gains are rounded to this number of digits, as people write them into a file."""


def can_be_tuned(controller: ControllerModel) -> bool:
    """Return whether the law of a controller has gains that follow from bandwidth and damping."""
    return isinstance(controller.gains, CascadedGains | ComputedTorqueGains | PiGains | FlowGains)


def has_damping(controller: ControllerModel) -> bool:
    """Return whether gains follow from a damping ratio, too."""
    return isinstance(controller.gains, CascadedGains | ComputedTorqueGains)


def loop_bandwidths(robot: Mechanism, controller: ControllerModel) -> Array:
    """Return ω of each axis under a controller [rad/s], shape (n,); of a hydraulic axis its crossover.

    Args:
        robot: with drives.
        controller: of the arm; it can be tuned. Of a cascade the damping counts as that of standard gains,
            of parallel PI loops the corner of the integral action as that of their rule.
    """
    gains, axes = controller.gains, hydraulic_axes(robot)
    if isinstance(gains, ComputedTorqueGains):
        return np.sqrt(gains.kp)
    if isinstance(gains, PiGains):
        return np.asarray(gains.ki / (INTEGRAL * gains.kp))
    if isinstance(gains, FlowGains):
        return np.asarray(gains.kp)
    assert isinstance(gains, CascadedGains)
    found = 2.0 * STANDARD_DAMPING * gains.kp
    found[axes] = gains.kp[axes] / CORNER_SHARE
    return np.asarray(found)


def tuned_controller(
    robot: Mechanism, controller: ControllerModel, bandwidths: Array, damping: float = STANDARD_DAMPING
) -> ControllerModel:
    """Return a controller whose law has gains with given bandwidths, rounded to four digits.

    Args:
        robot: with drives.
        controller: law and rates; it can be tuned.
        bandwidths: ω of each axis [rad/s], of a hydraulic axis its crossover, shape (n,).
        damping: ζ of all axes but the hydraulic ones.
    """
    crossovers = 2.0 * damping * bandwidths
    gains: Gains
    if isinstance(controller.gains, ComputedTorqueGains):
        gains = ComputedTorqueGains(bandwidths**2, crossovers, TORQUE_SHARE * crossovers)
    elif isinstance(controller.gains, PiGains):
        rule = _pi_rule(robot, controller.rates)
        kp = rule.kp * bandwidths / loop_bandwidths(robot, replace(controller, gains=rule))
        gains = PiGains(kp, INTEGRAL * bandwidths * kp)
    elif isinstance(controller.gains, FlowGains):
        rule_ = flow_gains(robot, controller.rates)
        more = bandwidths / rule_.kp
        gains = FlowGains(
            kp=bandwidths,
            ki=INTEGRAL * bandwidths**2,
            kd=more * rule_.kd,
            corner=CORNER * bandwidths,
            lead=rule_.lead,
            swing=more * rule_.swing,
        )
    else:
        loops = LoopBandwidths(crossovers, bandwidths / (2.0 * damping), INTEGRAL_SHARE * crossovers)
        cascade, axes = cascaded_gains(robot, loops), hydraulic_axes(robot)
        gains = with_hydraulic_axes(cascade, robot, bandwidths[axes]) if axes else cascade
    values = {name: _rounded(getattr(gains, name)) for name in gain_names(gains)}
    return replace(controller, gains=type(gains)(**values))


@lru_cache(maxsize=16)
def _pi_rule(robot: Mechanism, rates: Rates) -> PiGains:
    return parallel_pi_gains(robot, rates)


def _rounded(values: Array) -> Array:
    return np.array([float(f"{one:.{_DIGITS - 1}e}") for one in values.tolist()])
