"""Parallel PI loops: one for each axis, u = kp·e + ki·∫e dt, and nothing fed forward."""

import numpy as np

from ropsim.controller.law import CompiledLaw, LawTraits
from ropsim.controller.law_gains import gain_rows
from ropsim.dynamics import command_limit
from ropsim.model import ControllerModel, Mechanism, PiGains

SOURCE = """\
def law(par, state, ref, meas, out):
    for j in range(out.shape[0]):
        error = ref[0, j] - meas[0, j]
        u = par[kp, j] * error + state[integral, j]
        if abs(u) < par[limit, j]:
            state[integral, j] += par[ki, j] * error * par[period, j]
        out[j] = u
"""


def parallel_pi(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the law of parallel PI loops; see `model.PiGains`.

    Args:
        model: gains and control period.
        robot: the largest outputs of its amplifiers say where integrals stand still.

    Raises:
        GainError: the gains belong to another law, or do not have a number per axis.
    """
    n = robot.n
    kp, ki = gain_rows(model, PiGains, n)
    limit = np.array([min(command_limit(drive), 1e30) for drive in robot.drives])
    rows = {"kp": kp, "ki": ki, "limit": limit, "period": np.full(n, model.rates.control_period)}
    return CompiledLaw(
        name="parallel_pi",
        source=SOURCE,
        parameter_names=tuple(rows),
        parameters=np.stack(list(rows.values())),
        traits=LawTraits(state_names=("integral",), hold_row=0),
    )
