"""The source of a servo slice: plant, law of the joint controller, and the loops around them."""

from ropsim.codegen import Bounds, SourceFunction
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.dynamics import ArmStructure, step_code
from ropsim.simulation.servo.log import LogLayout, floors
from ropsim.simulation.servo.plant_code import plant_code
from ropsim.simulation.servo.state import StateLayout

LAW_SIGNATURE = "void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1], f8[::1])"
SLICE_SIGNATURE = (
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[:,::1],"
    " f8[::1], i8, f8, f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], i8, i8, i8,"
    " f8[:,::1])"
)


def servo_functions(structure: ArmStructure, law: CompiledLaw) -> tuple[SourceFunction, ...]:
    """Return the functions of the slice module; `run_slice` is the last."""
    return (
        *plant_code(structure).functions,
        *((step_code(StateLayout.of(structure, law.traits).loops),) if structure.cuts else ()),
        *law.functions,
        SourceFunction("law", LAW_SIGNATURE, law.source, Bounds.CHECKED),
        SourceFunction("run_slice", SLICE_SIGNATURE, _slice_text(structure, law.traits)),
    )


def _slice_text(structure: ArmStructure, traits: LawTraits) -> str:
    """Return `run_slice`: law, amplifiers and `plant_steps` Runge-Kutta steps for every tick, log and tally.

    The steps are as in the classical method; those of closed chains are made by `loop_step`. The law receives
    the values at the beginning of a tick: the reference in force and the measurement. At its end the next row
    of the reference comes into force. A row of the log holds the values at that time, and the output of the
    amplifiers over the tick. `values` is the state vector; `ref`, `pending` and `memory` are parts of it by
    rows; `frame` (4, n), `stages` (5, m) and `now` (w,) are work arrays. Every tick enters the tally
    (4, w): `ends` (2, n) are the ranges of the joints, `full` (w,) are the values that count as limits; for
    pressures, the judged quantity is the distance below the limit. Arguments that rarely change come first.
    """
    n = structure.n
    layout = StateLayout.of(structure, traits)
    size = layout.integrated
    motors = [
        f"seen[1, {axis}] = x[{place}]"
        for axis, place in enumerate(layout.measured_speeds)
        if place != n + axis
    ]
    at_motors = "".join(f"\n        {line}" for line in motors)
    amplified = _delayed(n, traits.delay) if traits.delay else "amplify(out, constants, u)"
    step = "loop_step(x, u, h, stages, constants)" if structure.cuts else _RUNGE_KUTTA.format(size=size)
    log = LogLayout.of(structure.drives)
    q_ref, qd_ref = log.field("q_ref").first, log.field("qd_ref").first
    q = log.field("q").first
    below = "".join(
        f"\n        for j in range({field.first}, {field.place.stop}):\n"
        f"            now[j] = max({least!r} - now[j], 0.0)"
        for name, least in floors(structure.drives).items()
        for field in (log.field(name),)
    )
    return f"""\
def run_slice(
    values, ref, pending, memory, par, frame, stages, now, ends, full, plant_steps, period, constants, load,
    q_ref, qd_ref, qdd_ref, aux, log, tick, decimation, log_row, tally,
):
    x, u = values[:{size}], values[{size}:{size + n}]
    seen, out = frame[:3], frame[3]
    y, k1, k2, k3, k4 = stages[0], stages[1], stages[2], stages[3], stages[4]
    h = period / plant_steps
    half = 0.5 * h
    sixth = h / 6.0
    row = log_row
    for k in range(q_ref.shape[0]):
        for j in range({n}):
            seen[0, j] = x[j]
            seen[1, j] = x[{n} + j]{at_motors}
        efforts(x, u, constants, seen[2])
        law(par, memory, ref, seen, load, aux[k], out)
        {amplified}
        for _ in range(plant_steps):
            {step}
        for j in range({n}):
            ref[0, j] = q_ref[k, j]
            ref[1, j] = qd_ref[k, j]
            ref[2, j] = qdd_ref[k, j]
        observe(x, u, constants, now)
        for j in range({n}):
            now[{q_ref} + j] = ref[0, j]
            now[{qd_ref} + j] = ref[1, j]
        if (tick + k + 1) % decimation == 0:
            for j in range({log.width}):
                log[row, j] = now[j]
            row += 1
        for j in range({n}):
            now[{q} + j] = max(x[j] - ends[1, j], ends[0, j] - x[j], 0.0)
            now[{q_ref} + j] -= x[j]{below}
        for j in range({log.width}):
            size = abs(now[j])
            if size > tally[0, j]:
                tally[0, j] = size
                tally[1, j] = tick + k + 1
            if size >= full[j]:
                tally[2, j] += 1.0
                tally[3, j] = tick + k + 1
"""


_RUNGE_KUTTA = """\
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
                x[j] += sixth * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j])"""
"""A step from `x` on, in the loop of `run_slice`."""


def _delayed(n: int, delay: int) -> str:
    """Return the statements that let an output wait for `delay` control ticks."""
    return f"""\
amplify(pending[0], constants, u)
        for d in range({delay - 1}):
            for j in range({n}):
                pending[d, j] = pending[d + 1, j]
        for j in range({n}):
            pending[{delay - 1}, j] = out[j]"""
