"""The source of a servo slice: traced plant, law of the joint controller, and the loops around them."""

from functools import lru_cache

from ropsim.codegen import Bounds, Engine, Formula, GivenCode, Scalar, SourceFunction, Tracer, load
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.dynamics import (
    ArmStructure,
    arm_numbers,
    sides_of,
    structure_of,
    trace_arm,
    trace_drives,
    trace_forward,
    traced_numbers,
)
from ropsim.model import RobotModel
from ropsim.simulation.servo_log import LogLayout
from ropsim.simulation.servo_state import StateLayout
from ropsim.spatial import Array

LAW_SIGNATURE = "void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1], f8[::1])"
SLICE_SIGNATURE = (
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1],"
    " f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], i8, i8, i8, i8, f8)"
)


def servo_functions(structure: ArmStructure, law: CompiledLaw) -> tuple[SourceFunction, ...]:
    """Return the functions of the slice module; `run_slice` is the last."""
    return (
        *plant_code(structure).functions,
        SourceFunction("law", LAW_SIGNATURE, law.source, Bounds.CHECKED),
        SourceFunction("run_slice", SLICE_SIGNATURE, _slice_text(structure, law.traits)),
    )


@lru_cache(maxsize=64)
def plant_code(structure: ArmStructure) -> GivenCode:
    """Return `amplify`, `derivative`, `efforts` and `observe` of arm and drives.

    `amplify(command, constants, u)` gives what the amplifiers put out; `derivative(x, u, constants, dx)` the
    rates of the integrated part of the state; `efforts(x, u, constants, tau)` the torques of the drives at
    the joints; `observe(x, u, constants, row)` a row of the log without the reference.
    """
    tracer, n = Tracer(), structure.n
    layout = StateLayout.of(structure.drives, LawTraits())
    numbers = traced_numbers(tracer, structure)
    x = tracer.variables("x", layout.integrated)
    command, u = tracer.variables("command", n), tracer.variables("u", n)
    outputs = [chain.amplified(numbers.drives[k], command[k]) for k, chain in enumerate(structure.drives)]
    q, qd = x[layout.q], x[layout.qd]
    places = [layout.drive(k) for k in range(n)]
    states = [[x[place] for place in own] for own in places]
    carried = trace_drives(structure, numbers.drives, (q, qd), states, u)
    tau = [one.effort for one in carried]
    arm = trace_arm(tracer, structure, numbers, q)
    rates: list[Scalar] = [*qd, *trace_forward(arm, qd, tau, sides_of(tracer, carried))]
    results = [(f"dx[{k}]", rate) for k, rate in enumerate(rates)]
    for own, one in zip(places, carried, strict=True):
        results += [(f"dx[{place}]", rate) for place, rate in zip(own, one.rates, strict=True)]
    return GivenCode.of(
        Formula("amplify", ("command", "u"), [(f"u[{k}]", one) for k, one in enumerate(outputs)]),
        Formula("derivative", ("x", "u", "dx"), results),
        Formula("efforts", ("x", "u", "tau"), [(f"tau[{k}]", one) for k, one in enumerate(tau)]),
        Formula("observe", ("x", "u", "row"), _row(structure, layout, x, u, tau)),
    )


def observe(robot: RobotModel, x: Array, u: Array, row: Array) -> None:
    """Enter everything but the reference into a row of the log.

    Args:
        robot: arm with drives.
        x: integrated part of the state vector.
        u: what the amplifiers put out.
        row: of the log; written in place.
    """
    _evaluated(robot, "observe", x, u, row)


def efforts(robot: RobotModel, x: Array, u: Array, tau: Array) -> None:
    """Enter the torques of the drives at the joints into `tau`; arguments are those of `observe`."""
    _evaluated(robot, "efforts", x, u, tau)


def _evaluated(robot: RobotModel, name: str, x: Array, u: Array, result: Array) -> None:
    """Evaluate a function of the plant once: plain Python is faster than compiling it."""
    code = plant_code(structure_of(robot))
    (source,) = (function for function in code.functions if function.name == name)
    load(name, (source,), Engine.PYTHON)(x, u, _constants(robot), result)


@lru_cache(maxsize=64)
def _constants(robot: RobotModel) -> Array:
    return plant_code(structure_of(robot)).constants(arm_numbers(robot))


def _row(
    structure: ArmStructure, layout: StateLayout, x: list[Scalar], u: list[Scalar], tau: list[Scalar]
) -> list[tuple[str, Scalar]]:
    """Return what `observe` enters: everything but the reference."""
    known = {"q": x[layout.q], "qd": x[layout.qd], "tau": tau}
    states = {field.name: field for field in layout.drives}
    results = []
    for field in LogLayout.of(structure.drives).fields:
        for place, axis in enumerate(field.axes, field.first):
            if field.name in known:
                results.append((f"row[{place}]", known[field.name][axis]))
            elif field.name in states:
                state = states[field.name]
                results.append((f"row[{place}]", x[state.first + state.axes.index(axis)]))
            elif field.name == structure.drives[axis].amplifier.output.name:
                results.append((f"row[{place}]", u[axis]))
    return results


def _slice_text(structure: ArmStructure, traits: LawTraits) -> str:
    """Return `run_slice`: law, amplifiers, `plant_steps` classical Runge-Kutta steps and log for every tick.

    A row of the log is what holds at the end of a tick, beside the reference of that tick and what the
    amplifiers put out over it. `values` is the state vector, `pending` and `memory` are parts of it by rows;
    `frame` (7, n) and `stages` (5, m) are room to work in.
    """
    n = structure.n
    size = StateLayout.of(structure.drives, traits).integrated
    amplified = _delayed(n, traits.delay) if traits.delay else "amplify(out, constants, u)"
    log = LogLayout.of(structure.drives)
    q_ref, qd_ref = log.field("q_ref").first, log.field("qd_ref").first
    return f"""\
def run_slice(
    values, pending, memory, q_ref, qd_ref, qdd_ref, aux, par, constants, load, log, frame, stages,
    tick, decimation, log_row, plant_steps, period,
):
    x, u = values[:{size}], values[{size}:{size + n}]
    ref, seen, out = frame[:3], frame[3:6], frame[6]
    y, k1, k2, k3, k4 = stages[0], stages[1], stages[2], stages[3], stages[4]
    h = period / plant_steps
    half = 0.5 * h
    sixth = h / 6.0
    row = log_row
    for k in range(q_ref.shape[0]):
        for j in range({n}):
            ref[0, j] = q_ref[k, j]
            ref[1, j] = qd_ref[k, j]
            ref[2, j] = qdd_ref[k, j]
            seen[0, j] = x[j]
            seen[1, j] = x[{n} + j]
        efforts(x, u, constants, seen[2])
        law(par, memory, ref, seen, load, aux[k], out)
        {amplified}
        for _ in range(plant_steps):
            derivative(x, u, constants, k1)
            for j in range({size}):
                y[j] = x[j] + half * k1[j]
            derivative(y, u, constants, k2)
            for j in range({size}):
                y[j] = x[j] + half * k2[j]
            derivative(y, u, constants, k3)
            for j in range({size}):
                y[j] = x[j] + h * k3[j]
            derivative(y, u, constants, k4)
            for j in range({size}):
                x[j] += sixth * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j])
        if (tick + k + 1) % decimation == 0:
            observe(x, u, constants, log[row])
            for j in range({n}):
                log[row, {q_ref} + j] = ref[0, j]
                log[row, {qd_ref} + j] = ref[1, j]
            row += 1
"""


def _delayed(n: int, delay: int) -> str:
    """Return the statements that let an output wait for `delay` control ticks."""
    return f"""\
amplify(pending[0], constants, u)
        for d in range({delay - 1}):
            for j in range({n}):
                pending[d, j] = pending[d + 1, j]
        for j in range({n}):
            pending[{delay - 1}, j] = out[j]"""
