"""The computed-torque law: the model of the arm converts requested accelerations to torques.

J. Y. S. Luh, M. W. Walker, R. P. Paul: Resolved-acceleration control of mechanical manipulators, IEEE Trans.
Automatic Control 25 (1980), 468-474; in joint coordinates as in J. J. Craig, Introduction to Robotics,
chapter 10. The equations of motion are written into the law, with the numbers of the arm among its
parameters, so that arms of one structure share the code.
"""

from functools import lru_cache

import numpy as np

from ropsim.codegen import Scalar, Tracer, emit, maximum, minimum
from ropsim.controller.law import CompiledLaw, LawTraits
from ropsim.controller.law_gains import gain_rows
from ropsim.dynamics import (
    ArmStructure,
    arm_numbers,
    check_model,
    command_limit,
    split_numbers,
    structure_of,
    trace_loaded_inverse,
)
from ropsim.model import ComputedTorqueGains, ControllerModel, InputKind, Mechanism

_KP, _KD, _LIMIT, _RATIO, _NUMBERS = range(5)
"""Rows of the parameters; from the last on stand the numbers of the arm, n in a row."""
_LOAD = 10
_OPEN = 1e30
"""Stands for the limit of an amplifier without a limit [N·m | N]."""


def computed_torque(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the computed-torque law of a controller; see `model.ComputedTorqueGains` for the equations.

    Args:
        model: its gains.
        robot: arm whose drives take torques or forces.

    Raises:
        GainError: the gains belong to another law, or do not have a number per axis.
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    check_model(robot)
    n, structure = robot.n, structure_of(robot)
    gains = gain_rows(model, ComputedTorqueGains, n)
    limits = [min(command_limit(drive), _OPEN) for drive in robot.drives]
    ratios = [abs(drive.ratio_at(q)) for drive, q in zip(robot.drives, robot.home.tolist(), strict=True)]
    numbers = np.array(arm_numbers(robot))
    numbers[numbers == np.inf] = _OPEN
    rows = np.concatenate((numbers, np.zeros(-len(numbers) % n))).reshape(-1, n)
    names = (*("kp", "kd", "limit", "ratio"), *(f"arm {k + 1}" for k in range(len(rows))))
    return CompiledLaw(
        name="computed_torque",
        source=_source(structure),
        parameter_names=names,
        parameters=np.vstack((*gains, limits, ratios, rows)),
        traits=LawTraits(u_kind=InputKind.EFFORT),
    )


@lru_cache(maxsize=16)
def _source(structure: ArmStructure) -> str:
    tracer, n = Tracer(), structure.n

    def read(name: str, number: int) -> list[Scalar]:
        return [tracer.variable(f"{name}[{number}, {k}]") for k in range(n)]

    zero = tracer.constant(0.0)
    numbers = [
        tracer.variable(f"par[{_NUMBERS + k // n}, {k % n}]") if there else zero
        for k, there in enumerate(structure.present)
    ]
    q, qd = read("meas", 0), read("meas", 1)
    q_ref, qd_ref, qdd_ref = (read("ref", k) for k in range(3))
    kp, kd, limit, ratio = (read("par", k) for k in (_KP, _KD, _LIMIT, _RATIO))
    wanted = [qdd_ref[k] + kd[k] * (qd_ref[k] - qd[k]) + kp[k] * (q_ref[k] - q[k]) for k in range(n)]
    load = tracer.variables("load", _LOAD)
    arm, motion = split_numbers(structure, numbers), (q, qd, wanted)
    tau = trace_loaded_inverse(tracer, structure, arm, motion, load, sliding=qd_ref)
    outputs = [minimum(maximum(tau[k] / ratio[k], -limit[k]), limit[k]) for k in range(n)]
    arguments = ("par", "state", "ref", "meas", "load", "aux", "out")
    return emit("law", arguments, [(f"out[{k}]", one) for k, one in enumerate(outputs)]).text
