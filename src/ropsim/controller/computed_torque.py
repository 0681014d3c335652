"""The computed-torque law: the model of the arm converts requested accelerations to torques.

J. Y. S. Luh, M. W. Walker, R. P. Paul: Resolved-acceleration control of mechanical manipulators, IEEE Trans.
Automatic Control 25 (1980), 468-474; in joint coordinates as in J. J. Craig, Introduction to Robotics,
chapter 10. The equations of motion are written into the law, with the numbers of the arm among its
parameters, so that arms of one structure share the code.

A motor behind an elastic gear of stiffness k runs ahead of its joint by the twist τ/k, so that its reference
has the speed q̇_ref + M·q⃛_ref/k and the acceleration q̈_ref + M·q⃜_ref/k, M being the mass matrix of links and
load (A. De Luca: Feedforward/feedback laws for the control of flexible robots, ICRA 2000, 233-240; changes
of gravity and Coriolis forces within the time of a swing are left out). Both are differences over a tick,
the speed smoothed a little.

In an arm with closed chains the law follows these from tick to tick, and brings the torques of all joints to
the axes by virtual work (`dynamics.closed_law_code`). Parallelograms are couplings, as in an open chain.
"""

from functools import lru_cache
from math import ceil, isfinite
from sys import float_info

import numpy as np

from ropsim.codegen import Scalar, SourceFunction, Tracer, emit
from ropsim.controller.law import CompiledLaw, LawTraits
from ropsim.controller.law_gains import gain_rows
from ropsim.dynamics import (
    ArmStructure,
    arm_numbers,
    check_model,
    closed_law_code,
    command_band,
    command_limit,
    elastic_axes,
    gear_stiffnesses,
    split_numbers,
    steady_drive,
    structure_of,
    trace_loaded_inverse,
    trace_loaded_links,
    with_rigid_gears,
)
from ropsim.kinematics import without_linear_loops
from ropsim.model import ComputedTorqueGains, ControllerModel, Drive, Mechanism

_ROWS = (
    *("kp", "kd", "ki", "period"),
    *("per_effort", "per_speed", "limit", "band", "span", "softness"),
)
"""Rows of the parameters before the numbers of the arm, n in a row."""
_KP, _KD, _KI, _PERIOD, _PER_EFFORT, _PER_SPEED, _LIMIT, _BAND, _SPAN, _SOFTNESS = range(len(_ROWS))
_NEWER = 0.5
"""Share of a twist speed that counts at its tick: a step of the jerk would need all torque there is."""
_LOAD = 10
_OPEN = 1e30
"""Stands for the limit of an amplifier without a limit [N·m | N]."""
_STIFF = ("integral",)
_SOFT = ("integral", "acceleration", "twist_speed")
"""States of the law: with elastic gears also reference acceleration and twist speed of the tick before."""

_COARSE = 2.0**19
"""Added and taken away it rounds the integral to 1e-10 rad/s²: digits that move no joint would last for ever,
and an arm would not come back, to the bit, to the state of a run that began elsewhere."""

_LAW = f"""\
def law(par, state, ref, meas, load, aux, out):
    torques(par.reshape(-1), state.reshape(-1), ref.reshape(-1), meas.reshape(-1), load, out)
    for j in range(out.shape[0]):
        speed = ref[1, j]{{twist}}
        u = par[{_PER_EFFORT}, j] * out[j] + par[{_PER_SPEED}, j] * speed
        limit = par[{_LIMIT}, j]
        if u > limit:
            u = limit
        elif u < -limit:
            u = -limit
        elif abs(u - par[{_BAND}, j] * meas[1, j]) <= par[{_SPAN}, j]:
            asked = par[{_KD}, j] * (speed - meas[1, j]) + par[{_KP}, j] * (ref[0, j] - meas[0, j])
            held = state[0, j] + par[{_KI}, j] * asked * par[{_PERIOD}, j]
            state[0, j] = (held + {_COARSE!r}) - {_COARSE!r}
        out[j] = u
"""
"""The results of `torques` in `out` become inputs of the amplifiers; while one of them is at its limit, the
integral of its axis stands still."""


def computed_torque(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the computed-torque law of a controller; see `model.ComputedTorqueGains` for the equations.

    Args:
        model: its gains and control period.
        robot: arm with drives whose gears have constant ratios, and are rigid where there are closed chains.

    Raises:
        GainError: the gains belong to another law, or do not have a number per axis.
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    check_model(robot)
    robot = without_linear_loops(robot)
    n, rigid = robot.n, with_rigid_gears(robot)
    gains = gain_rows(model, ComputedTorqueGains, n)
    numbers = np.array(arm_numbers(rigid))
    numbers[numbers == np.inf] = _OPEN
    arm = np.concatenate((numbers, np.zeros(-len(numbers) % n))).reshape(-1, n)
    inputs = [_input(drive, q) for drive, q in zip(robot.drives, robot.home.tolist(), strict=True)]
    softness, soft = 1.0 / gear_stiffnesses(robot), tuple(elastic_axes(robot).tolist())
    period, structure = np.full(n, model.rates.control_period), structure_of(rigid)
    chains = tuple(f"chain_{k + 1}" for k in range(ceil(structure.passive / n)))
    closed = structure.cuts != ()
    functions = _closed_torques(structure) if closed else (_torques(structure, soft),)
    return CompiledLaw(
        name="computed_torque",
        source=_LAW.format(twist=" + state[2, j]" if any(soft) else ""),
        parameter_names=(*_ROWS, *(f"arm {k + 1}" for k in range(len(arm)))),
        parameters=np.vstack((*gains, period, np.array(inputs).T, softness, arm)),
        traits=LawTraits(
            state_names=(*(_SOFT if any(soft) else _STIFF), *chains), chain_row=1 if chains else None
        ),
        functions=functions,
    )


def _input(drive: Drive, q: float) -> tuple[float, ...]:
    """Return command per effort, and per speed without effort, largest command, and band."""
    band = command_band(drive)
    return (
        steady_drive(drive, q, 0.0, 1.0).command,
        steady_drive(drive, q, 1.0, 0.0).command,
        min(command_limit(drive), _OPEN),
        band.per_speed,
        band.span if isfinite(band.span) else float_info.max,
    )


@lru_cache(maxsize=16)
def _torques(structure: ArmStructure, soft: tuple[bool, ...]) -> SourceFunction:
    """Return `torques(par, state, ref, meas, load, out)` of the rows one behind the other.

    Args:
        structure: of the arm with rigid gears.
        soft: which axes have elastic ones.
    """
    tracer, n = Tracer(), structure.n

    def read(name: str, number: int) -> list[Scalar]:
        return [tracer.variable(f"{name}[{number * n + k}]") for k in range(n)]

    zero = tracer.constant(0.0)
    numbers = [
        tracer.variable(f"par[{len(_ROWS) * n + k}]") if there else zero
        for k, there in enumerate(structure.present)
    ]
    arm, load = split_numbers(structure, numbers), tracer.variables("load", _LOAD)
    q, qd, (q_ref, qd_ref, qdd_ref) = read("meas", 0), read("meas", 1), (read("ref", k) for k in range(3))
    kp, kd, held = read("par", _KP), read("par", _KD), read("state", 0)
    motor_speed, motor_extra, kept = qd_ref, [zero] * n, []
    if any(soft):
        ticks = [1.0 / one for one in read("par", _PERIOD)]
        jerk = [(qdd_ref[k] - one) * ticks[k] for k, one in enumerate(read("state", 1))]
        pull = trace_loaded_links(tracer, structure, arm, (q, jerk), load)
        softness, before = read("par", _SOFTNESS), read("state", 2)
        twist = [
            before[k] + _NEWER * (softness[k] * pull[k] - before[k]) if soft[k] else zero for k in range(n)
        ]
        motor_speed = [qd_ref[k] + twist[k] for k in range(n)]
        motor_extra = [(twist[k] - before[k]) * ticks[k] if soft[k] else zero for k in range(n)]
        kept = [*((f"state[{n + k}]", one) for k, one in enumerate(qdd_ref))]
        kept += [(f"state[{2 * n + k}]", one) for k, one in enumerate(twist)]
    wanted = [
        qdd_ref[k] + kd[k] * (motor_speed[k] - qd[k]) + kp[k] * (q_ref[k] - q[k]) + held[k] for k in range(n)
    ]
    motors = motor_speed, [wanted[k] + motor_extra[k] for k in range(n)]
    tau = trace_loaded_inverse(tracer, structure, arm, (q, qd, wanted), load, motors)
    results = [*((f"out[{k}]", one) for k, one in enumerate(tau)), *kept]
    return emit("torques", ("par", "state", "ref", "meas", "load", "out"), results)


_CLOSED = f"""\
def torques(par, state, ref, meas, load, out):
    wanted = np.empty({{n}})
    for k in range({{n}}):
        asked = par[{{n}} * {_KD} + k] * (ref[{{n}} + k] - meas[{{n}} + k])
        asked += par[{{n}} * {_KP} + k] * (ref[k] - meas[k])
        wanted[k] = ref[{{n2}} + k] + asked + state[k]
    z, model = state[{{n}}:{{end}}], par[{{n}} * {len(_ROWS)}:]
    closed_inverse(z, meas[:{{n}}], meas[{{n}}:{{n2}}], wanted, ref[{{n}}:{{n2}}], model, load, out)
"""


@lru_cache(maxsize=16)
def _closed_torques(structure: ArmStructure) -> tuple[SourceFunction, ...]:
    """Return `torques` as `_torques` does, of an arm with closed chains, with the functions before it."""
    n, vectors = structure.n, ", ".join(["f8[::1]"] * 6)
    text = _CLOSED.format(n=n, n2=2 * n, end=n + structure.passive)
    return (*closed_law_code(structure), SourceFunction("torques", f"void({vectors})", text))
