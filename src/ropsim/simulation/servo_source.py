"""The source of a servo slice: traced plant, law of the joint controller, and the loops around them."""

from functools import lru_cache

from ropsim.codegen import Scalar, SourceFunction, Tracer, emit
from ropsim.controller import CompiledLaw
from ropsim.dynamics import direction, torque_per_ampere, trace_arm, trace_current_rate, trace_forward
from ropsim.model import Drive, RobotModel

LAW_SIGNATURE = "void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1])"
SLICE_SIGNATURE = (
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[:,::1],"
    " f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], i8, i8, i8, i8, f8)"
)
LOG_COLUMNS = ("q", "qd", "current", "voltage", "q_ref", "qd_ref")
"""Blocks of n columns in a row of the log."""


def servo_functions(robot: RobotModel, law: CompiledLaw) -> tuple[SourceFunction, ...]:
    """Return the functions of the slice module; `run_slice` is the last."""
    return (
        emit_derivative(robot),
        SourceFunction("law", LAW_SIGNATURE, law.source),
        SourceFunction("run_slice", SLICE_SIGNATURE, _slice_text(robot)),
    )


@lru_cache(maxsize=64)
def emit_derivative(robot: RobotModel) -> SourceFunction:
    """Return `derivative(x, u, load, dx)` of arm and drives.

    x is q, qd, motor current; u the motor voltages; load the last body. The torque at a joint is G·Kt·i.
    """
    n = robot.n
    tracer = Tracer()
    x = tracer.variables("x", 3 * n)
    q, qd, current = x[:n], x[n : 2 * n], x[2 * n :]
    voltage = tracer.variables("u", n)
    tau = [i * torque_per_ampere(drive) for i, drive in zip(current, robot.drives, strict=True)]
    arm = trace_arm(tracer, robot, q, tracer.variables("load", 10))
    rates: list[Scalar] = [*qd, *trace_forward(robot, arm, qd, tau)]
    for drive, speed, i, u in zip(robot.drives, qd, current, voltage, strict=True):
        rates.append(trace_current_rate(drive, speed, i, u))
    return emit("derivative", ("x", "u", "load", "dx"), [(f"dx[{k}]", rate) for k, rate in enumerate(rates)])


def _slice_text(robot: RobotModel) -> str:
    """Return `run_slice`: law, amplifier, `plant_steps` classical Runge-Kutta steps and log for every tick.

    A row of the log is what holds at the end of a tick, beside the reference and the voltage of that tick.
    `ref` (3, n), `meas` (2, n), `volts` (2, n) and `stages` (5, 3n) are room to work in.
    """
    n = robot.n
    amplifiers = "\n        ".join(_amplifier(j, drive) for j, drive in enumerate(robot.drives))
    return f"""\
def run_slice(
    x, memory, q_ref, qd_ref, qdd_ref, par, load, log, ref, meas, volts, stages,
    tick, decimation, log_row, plant_steps, period,
):
    out, u = volts[0], volts[1]
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
            meas[0, j] = x[j]
            meas[1, j] = x[{n} + j]
        law(par, memory, ref, meas, out)
        {amplifiers}
        for _ in range(plant_steps):
            derivative(x, u, load, k1)
            for j in range({3 * n}):
                y[j] = x[j] + half * k1[j]
            derivative(y, u, load, k2)
            for j in range({3 * n}):
                y[j] = x[j] + half * k2[j]
            derivative(y, u, load, k3)
            for j in range({3 * n}):
                y[j] = x[j] + h * k3[j]
            derivative(y, u, load, k4)
            for j in range({3 * n}):
                x[j] += sixth * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j])
        if (tick + k + 1) % decimation == 0:
            for j in range({n}):
                log[row, j] = x[j]
                log[row, {n} + j] = x[{n} + j]
                log[row, {2 * n} + j] = x[{2 * n} + j]
                log[row, {3 * n} + j] = u[j]
                log[row, {4 * n} + j] = ref[0, j]
                log[row, {5 * n} + j] = ref[1, j]
            row += 1
"""


def _amplifier(j: int, drive: Drive) -> str:
    """Return the statement that clips the output of the law and turns it into the motor's direction."""
    limit = drive.amplifier.max_voltage
    sign = "-" if direction(drive) < 0.0 else ""
    return f"u[{j}] = {sign}min(max(out[{j}], {-limit!r}), {limit!r})"
