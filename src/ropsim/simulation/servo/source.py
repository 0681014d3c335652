"""The source of a servo slice: plant, law of the joint controller, and the loops around them."""

from ropsim.codegen import SourceFunction
from ropsim.controller import CompiledLaw, law_code, law_functions
from ropsim.dynamics import SUPPLY, ArmStructure, step_code
from ropsim.simulation.servo.log import LogLayout, floors
from ropsim.simulation.servo.plant_code import plant_code
from ropsim.simulation.servo.sensing import Sensing
from ropsim.simulation.servo.state import StateLayout

SLICE_SIGNATURE = (
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[:,::1],"
    " f8[::1], i8, f8, f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], i8, i8, i8,"
    " f8[:,::1])"
)


MOST_OUTPUT = 1e300
"""A law that puts out more, or NaN, ends the run: the coordinate becomes NaN, which no later tick mends."""
NO_SENSORS = Sensing(())


def servo_functions(
    structure: ArmStructure, law: CompiledLaw, sensing: Sensing = NO_SENSORS, outside_rows: int = 0
) -> tuple[SourceFunction, ...]:
    """Return the functions of the slice module; `run_slice` is the last.

    Args:
        structure: of arm and drives.
        law: of the joint controller.
        sensing: what stands between arm and law.
        outside_rows: 1 where efforts from outside act on the axes, else 0.
    """
    return (
        *plant_code(structure, outside_rows).functions,
        *((step_code(StateLayout.of(structure, law.traits).loops),) if structure.cuts else ()),
        *sensing.functions,
        *law_functions(law),
        law_code(law).function,
        SourceFunction("run_slice", SLICE_SIGNATURE, _slice_text(structure, law, sensing, outside_rows)),
    )


def _slice_text(structure: ArmStructure, law: CompiledLaw, sensing: Sensing, outside_rows: int) -> str:
    """Return `run_slice`: law, amplifiers and `plant_steps` Runge-Kutta steps for every tick, log and tally.

    The steps are as in the classical method; those of closed chains are made by `loop_step`. The law receives
    the values at the beginning of a tick: the reference in force and the measurement. At its end the next row
    of the reference comes into force. A row of the log holds the values at that time, and the output of
    the amplifiers over the tick. `values` is the state vector; `ref`, `pending` and `memory` are parts of
    it by rows; `par` are the parameters of the law, and below them the rows of its model; `frame` (4 + r,
    n), `stages` (5, m) and `now` (w,) are work arrays, the last r rows of the frame for what the law
    reads of the drives and for its own work; behind the outputs of the amplifiers `u` has the efforts from
    outside, where there are some: they are held over all ticks of the slice. Every tick enters the tally
    (4, w): `ends` (2, n) are the ranges of the joints, `full` (2·w,) are the values that count as limits,
    then what quantities are to stay above; for pressures, the judged quantity is the distance below that.
    Arguments that rarely change come first.
    """
    n, traits = structure.n, law.traits
    layout = StateLayout.of(structure, traits)
    size = layout.integrated
    motors = [
        f"seen[0, {axis}] = x[{place}]"
        for axis, place in enumerate(layout.measured_coordinates)
        if place != axis
    ]
    motors += [
        f"seen[1, {axis}] = x[{place}]"
        for axis, place in enumerate(layout.measured_speeds)
        if place != n + axis
    ]
    at_motors = "".join(f"\n        {line}" for line in motors)
    sensed = "".join(
        f"\n        given[{row}, {axis}] = x[{place}]"
        for row, places in enumerate(layout.sensed(traits.sensed))
        for axis, place in enumerate(places)
        if place is not None
    )
    arguments, rows = _arguments(law, sensing)
    measured = "\n        measure(frame, sensors, kept, tick + k)" if sensing.channels else ""
    amplified = _delayed(n, traits.delay) if traits.delay else "amplify(out, constants, u)"
    step = "loop_step(x, u, h, stages, constants)" if structure.cuts else _RUNGE_KUTTA.format(size=size)
    log = LogLayout.of(structure.drives)
    q_ref, qd_ref = log.field("q_ref").first, log.field("qd_ref").first
    q = log.field("q").first
    least_of = {name: repr(least) for name, least in floors(structure.drives).items()}
    if SUPPLY.name in least_of:
        least_of[SUPPLY.name] = f"full[{log.width} + j]"
    below = "".join(
        f"\n        for j in range({field.first}, {field.place.stop}):\n"
        f"            now[j] = max({least} - now[j], 0.0)"
        for name, least in least_of.items()
        for field in (log.field(name),)
    )
    return f"""\
def run_slice(
    values, ref, pending, memory, par, frame, stages, now, ends, full, plant_steps, period, constants, load,
    q_ref, qd_ref, qdd_ref, aux, log, tick, decimation, log_row, tally,
):
    x, u = values[:{size}], values[{size}:{size + (1 + outside_rows) * n}]
    seen, out = frame[:3], frame[3]{rows}
    y, k1, k2, k3, k4 = stages[0], stages[1], stages[2], stages[3], stages[4]
    h = period / plant_steps
    half = 0.5 * h
    sixth = h / 6.0
    row = log_row
    for k in range(q_ref.shape[0]):
        for j in range({n}):
            seen[0, j] = x[j]
            seen[1, j] = x[{n} + j]{at_motors}
        efforts(x, u, constants, seen[2]){sensed}{measured}
        law({arguments})
        {amplified}
        for j in range({n}):
            if not abs(out[j]) <= {MOST_OUTPUT!r}:
                u[j] = out[j]
                x[j] = math.nan
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


def frame_rows(law: CompiledLaw) -> int:
    """Return the rows of the frame of a slice."""
    return 4 + len(law.traits.sensed) + len(law.work_names)


def _arguments(law: CompiledLaw, sensing: Sensing) -> tuple[str, str]:
    """Return the arguments of the call of a law, and the statements that make the arrays only some have."""
    first, last = len(law.parameter_names), 4 + len(law.traits.sensed)
    end = first + (len(law.model.rows) if law.model else 0)
    below = first + (len(law.model.drive_names) if law.model else 0)
    made = {
        "sensed": ("given", f"given = frame[4:{last}]"),
        "work": ("work", f"work = frame[{last}:{frame_rows(law)}]"),
        "drive": ("drive", f"drive = par[{first}:{below}]"),
        "model": ("model", f"model = par[{below}:{end}].reshape(-1)"),
    }
    names = {"par": "par", "state": "memory", "meas": "seen", "aux": "aux[k]"}
    if law.model or sensing.channels:
        names["par"] = f"par[:{first}]"
    names |= {name: used for name, (used, _) in made.items()}
    arguments = law_code(law).arguments
    needed = [text for name, (_, text) in made.items() if name in arguments]
    if law.traits.sensed and made["sensed"][1] not in needed:
        needed.append(made["sensed"][1])
    if sensing.channels:
        rows = len(law.traits.state_names)
        needed += [f"sensors = par[{end}:]", f"kept = memory[{rows}:]"]
        names["state"] = f"memory[:{rows}]"
    return ", ".join(names.get(name, name) for name in arguments), "".join(f"\n    {one}" for one in needed)
