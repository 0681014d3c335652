"""Gains from a bandwidth and a damping ratio, for each law that has them.

An axis under one of the laws is a mass between a spring and a damper, s² + 2·ζ·ω·s + ω²: computed torque has
kp = ω² and kd = 2·ζ·ω, a cascade the crossover 2·ζ·ω of its speed loop and kp = ω/(2·ζ). Integral action
stands to the crossover as in the standard gains, which have ζ = 0.91. A hydraulic axis has a
crossover alone: its damping comes from leakage.
"""

from dataclasses import replace

import numpy as np

from ropsim.model import (
    CascadedGains,
    ComputedTorqueGains,
    ControllerModel,
    Gains,
    Mechanism,
    gain_names,
)
from ropsim.robots.loops.cascaded_loops import (
    INTEGRAL_SHARE,
    POSITION_SHARE,
    LoopBandwidths,
    cascaded_gains,
)
from ropsim.robots.loops.hydraulic_loops import CORNER_SHARE, hydraulic_axes, with_hydraulic_axes
from ropsim.robots.loops.torque_loops import INTEGRAL_SHARE as TORQUE_SHARE
from ropsim.spatial import Array

STANDARD_DAMPING = 0.5 * POSITION_SHARE**-0.5
"""Damping ratio of the standard gains."""
_DIGITS = 4
"""Gains are rounded to this number of digits, as people write them into a file."""


def can_be_tuned(controller: ControllerModel) -> bool:
    """Return whether the law of a controller has gains that follow from bandwidth and damping."""
    return isinstance(controller.gains, CascadedGains | ComputedTorqueGains)


def loop_bandwidths(robot: Mechanism, controller: ControllerModel) -> Array:
    """Return ω of each axis under a controller [rad/s], shape (n,); of a hydraulic axis its crossover.

    Args:
        robot: with drives.
        controller: of the arm; it can be tuned. Of a cascade the damping counts as that of standard gains.
    """
    gains, axes = controller.gains, hydraulic_axes(robot)
    if isinstance(gains, ComputedTorqueGains):
        return np.sqrt(gains.kp)
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
    else:
        loops = LoopBandwidths(crossovers, bandwidths / (2.0 * damping), INTEGRAL_SHARE * crossovers)
        cascade, axes = cascaded_gains(robot, loops), hydraulic_axes(robot)
        gains = with_hydraulic_axes(cascade, robot, bandwidths[axes]) if axes else cascade
    values = {name: _rounded(getattr(gains, name)) for name in gain_names(gains)}
    return replace(controller, gains=type(gains)(**values))


def _rounded(values: Array) -> Array:
    return np.array([float(f"{one:.{_DIGITS - 1}e}") for one in values.tolist()])
