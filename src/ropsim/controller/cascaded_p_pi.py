"""The cascaded P-PI law."""

from math import isfinite
from sys import float_info

import numpy as np

from ropsim.controller.law import CompiledLaw, LawTraits
from ropsim.controller.law_gains import gain_rows
from ropsim.dynamics import command_band, command_limit
from ropsim.model import GAIN_NAMES, CascadedGains, ControllerModel, Mechanism

_SOURCE = '''\
def law(par, state, ref, meas, load, aux, out):
    """Position loop P, speed loop PI, both with feed-forward; see model.CascadedGains."""
    for j in range(out.shape[0]):
        speed_error = par[0, j] * (ref[0, j] - meas[0, j]) + par[3, j] * ref[1, j] - meas[1, j]
        u = par[1, j] * speed_error + state[0, j] + par[4, j] * ref[1, j] + par[5, j] * ref[2, j]
        limit = par[6, j]
        if u > limit:
            u = limit
        elif u < -limit:
            u = -limit
        {otherwise}:
            state[0, j] += par[2, j] * speed_error * par[7, j]
        out[j] = u
'''
CASCADED_P_PI_SOURCE = _SOURCE.format(otherwise="else")
LIMITED_SOURCE = _SOURCE.format(otherwise="elif abs(u - par[8, j] * meas[1, j]) <= par[9, j]")
"""For drives of which one limits its current: there the integral must also be frozen."""


def cascaded_p_pi(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the cascaded P-PI law of a controller; see `model.CascadedGains` for the equations.

    Args:
        model: gains and control period.
        robot: the amplifiers of its drives say at which output the integral has to stand still: the largest,
            and where one limits the current of its motor, the output that it allows at the measured speed.

    Raises:
        GainError: the gains belong to another law, or do not have a number per drive.
    """
    n = robot.n
    gains = gain_rows(model, CascadedGains, n)
    limits = [min(command_limit(drive), float_info.max) for drive in robot.drives]
    period = np.full(n, model.rates.control_period)
    rows = dict(zip((*GAIN_NAMES, "limit", "period"), (*gains, np.array(limits), period), strict=True))
    bands = [command_band(drive) for drive in robot.drives]
    is_limited = any(isfinite(band.span) for band in bands)
    if is_limited:
        rows["per_speed"] = np.array([band.per_speed for band in bands])
        rows["span"] = np.array([min(band.span, float_info.max) for band in bands])
    return CompiledLaw(
        name="cascaded_p_pi",
        source=LIMITED_SOURCE if is_limited else CASCADED_P_PI_SOURCE,
        parameter_names=tuple(rows),
        parameters=np.stack(list(rows.values())),
        traits=LawTraits(state_names=("integral",), hold_row=0),
    )
