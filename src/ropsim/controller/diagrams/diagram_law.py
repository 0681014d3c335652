"""A block diagram as a compiled law: blocks in order, with their numbers as parameters of the law.

At the first tick the memory of the blocks is filled so that they rest on their first inputs, each pass of the
loop `attempt` with the values of the one before; the integral of the block that holds the arm takes the
difference between the output and the one that holds the arm. `x[0]` says whether that has been done. Row 0 of
the memory is written at every tick and depends on nothing, so that it adds no pole to the loop.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ropsim import blockdiagram as b
from ropsim.controller.diagrams import memory_blocks, static_blocks
from ropsim.controller.diagrams.fitting import check_fit
from ropsim.controller.diagrams.model_blocks import WORK, drive_command, model_feed_forward, motion_efforts
from ropsim.controller.diagrams.pid_block import pid
from ropsim.controller.diagrams.written import Written
from ropsim.controller.law import CompiledLaw, LawTraits
from ropsim.controller.law_code import in_python, law_arrays
from ropsim.controller.law_diagnostics import LAW_DOES_NOT_FIT, LawError
from ropsim.controller.law_model import law_model
from ropsim.model import Mechanism

BLOCK_CODE: dict[type[b.Block], Callable[[Any, Written], object]] = {
    b.Gain: static_blocks.gain,
    b.MatrixGain: static_blocks.matrix_gain,
    b.Sum: static_blocks.sum_,
    b.Product: static_blocks.product,
    b.Constant: static_blocks.constant,
    b.Saturation: static_blocks.saturation,
    b.DeadBand: static_blocks.dead_band,
    b.Lookup: static_blocks.lookup,
    b.Switch: static_blocks.switch,
    b.StateSpace: memory_blocks.state_space,
    b.Integrator: memory_blocks.integrator,
    b.RateLimiter: memory_blocks.rate_limiter,
    b.Delay: memory_blocks.delay,
    b.MovingFilter: memory_blocks.moving_filter,
    b.Pid: pid,
    b.ModelFeedForward: model_feed_forward,
}
"""Who writes the code of a block that is no filter; that of `DriveCommand` depends on the drives."""
_ROWS = {
    b.Role.REFERENCE_COORDINATE: "ref[0, {k}]",
    b.Role.REFERENCE_SPEED: "ref[1, {k}]",
    b.Role.REFERENCE_ACCELERATION: "ref[2, {k}]",
    b.Role.COORDINATE: "meas[0, {k}]",
    b.Role.SPEED: "meas[1, {k}]",
    b.Role.EFFORT: "meas[2, {k}]",
}
_STARTED, _HELD = "started", "held"
_WEAKEST = 1e-9
"""Least change of an output by the integral that is to hold the arm, over the greatest of all axes."""


def diagram_law(diagram: b.Diagram, robot: Mechanism) -> CompiledLaw:
    """Return the law of a controller that is given as a block diagram.

    Args:
        diagram: the controller.
        robot: arm with drives.

    Raises:
        DiagramError: C621 to C626, the diagram is wrong or does not fit the arm.
        LawError: C602, the block that is to hold the arm has no influence on an axis.
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    b.check_diagram(diagram)
    check_fit(diagram, robot)
    made = _law(diagram, robot, np.zeros(robot.n))
    return _law(diagram, robot, _influence(made, robot)) if diagram.holding else made


def _influence(law: CompiledLaw, robot: Mechanism) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return 1 over the change of the output of each axis by the integral that holds it.

    The law is called at rest with all zeros, and once more with integrals of 1.
    """
    function, n = in_python(law), robot.n
    outs = []
    for value in (0.0, 1.0):
        arrays = law_arrays(law, n)
        arrays["state"][1] = value
        arrays["work"] = np.zeros((len(WORK), n))
        with np.errstate(all="ignore"):
            function(arrays)
        outs.append(arrays["out"].copy())
    change = outs[1] - outs[0]
    largest = float(np.abs(change).max(initial=0.0))
    weak = np.flatnonzero(~(np.abs(change) > _WEAKEST * largest))
    if len(weak) or not np.isfinite(change).all():
        axis = int(weak[0]) + 1 if len(weak) else 1
        message = f"the block that is to hold the arm does not change the output of axis {axis}"
        hint = "name a PID block or an integrator behind which no limit or switch stands"
        raise LawError(LAW_DOES_NOT_FIT.at(None, message, hint=hint))
    return np.asarray(1.0 / change)


def _law(diagram: b.Diagram, robot: Mechanism, influence: np.ndarray[Any, Any]) -> CompiledLaw:
    n, wiring = robot.n, b.wiring_of(diagram)
    to = Written(diagram, wiring, 2 * n)
    holding: list[str] = []
    for number in wiring.order:
        block = diagram.blocks[number]
        first = to.size
        if isinstance(block, b.DriveCommand):
            drive_command(block, to, robot)
            continue
        written = _write(block, to)
        if block.name == diagram.holding:
            places = written if isinstance(written, dict) else {}
            holding = [places[k] for k in range(n)] if places else [f"x[{first + k}]" for k in range(n)]
    output = next(one for one in diagram.signals if one.role is b.Role.OUTPUT)
    out = to.elements(output.name)
    inverse = to.numbers_from(influence) if holding else 0
    held = _held(holding, out, inverse, first_try=not influence.any())
    source = _text(to, out, held, _late(diagram))
    rows = -(-len(to.numbers) // n) or 1
    parameters = np.zeros(rows * n)
    parameters[: len(to.numbers)] = to.numbers
    states = -(-to.size // n) - 2
    sensed = tuple(dict.fromkeys(one.channel for one in diagram.signals if one.role is b.Role.DRIVE_STATE))
    uses_model = any(isinstance(one, b.ModelFeedForward) for one in diagram.blocks)
    return CompiledLaw(
        name=_identifier(diagram.name),
        source=source,
        parameter_names=tuple(f"numbers {k + 1}" for k in range(rows)),
        parameters=parameters.reshape(rows, n),
        traits=LawTraits(
            u_kind=b.INPUT_KINDS[diagram.output_kind],
            state_names=(_STARTED, _HELD, *(f"memory {k + 1}" for k in range(states))),
            hold_row=1 if holding else None,
            aux=_channels(diagram),
            delay=diagram.delay,
            sensed=sensed,
            sensed_axes=(),  # `check_fit` checks the elements that are read
        ),
        functions=(motion_efforts(robot),) if uses_model else (),
        model=law_model(robot),
        work_names=WORK if uses_model else (),
    )


def _write(block: b.Block, to: Written) -> object:
    """Write the code of a block and return what it says about its memory."""
    made = b.filter_of(block)
    if made is None:
        return BLOCK_CODE[type(block)](block, to)
    memory_blocks.filtered(block, made, to)
    return None


def _late(diagram: b.Diagram) -> int:
    """Return how often the first tick is computed until all memory rests, the integral that holds aside."""
    return sum(not b.passes_at_once(one) for one in diagram.blocks)


def _held(holding: list[str], out: list[str], inverse: int, *, first_try: bool) -> list[str]:
    """Return the statements that let integrals hold the arm; at first they only take given values."""
    lines = []
    for k, one in enumerate(holding):
        lacking = f"held[{k}]" if first_try else f"(held[{k}] - {out[k]}) * p[{inverse + k}]"
        lines.append(f"{one} = {lacking}" if first_try else f"{one} += {lacking}")
    return lines


def _text(to: Written, out: list[str], held: list[str], late: int) -> str:
    """Return the source of the law."""
    n, diagram = len(out), to.diagram
    sensed = any(one.role is b.Role.DRIVE_STATE for one in diagram.signals)
    uses_model = any(isinstance(one, b.ModelFeedForward) for one in diagram.blocks)
    arguments = ["par", "state", "ref", "meas", *(["sensed"] if sensed else [])]
    arguments += [*(["model", "work"] if uses_model else []), "load", "aux", "out"]
    end = -(-to.size // n) * n
    loop = [*to.outputs, *to.after]
    if held:
        loop += [f"if fresh and attempt == {late}:", *(f"    {line}" for line in held)]
    body = [
        "p, x = par.reshape(-1), state.reshape(-1)",
        "fresh = x[0] == 0.0",
        f"passes = {2 * late + 2} if fresh else 1",
        f"held = x[{n}:{2 * n}]",
        *_inputs(to),
        "for attempt in range(passes):",
        *(f"    {line}" for line in loop or ["pass"]),
        *(f"out[{k}] = {one}" for k, one in enumerate(out)),
        *to.kept,
        f"for k in range({2 * n}):",
        "    x[k] = 0.0",
        *([f"for k in range({to.size}, {end}):", "    x[k] = 0.0"] if end > to.size else []),
        "x[0] = 1.0",
    ]
    lines = "".join(f"    {line}\n" for line in body)
    return f"def law({', '.join(arguments)}):\n{lines}"


def _inputs(to: Written) -> list[str]:
    lines, channels = [], _channels(to.diagram)
    states = list(dict.fromkeys(one.channel for one in to.diagram.signals if one.role is b.Role.DRIVE_STATE))
    for number, signal in enumerate(to.diagram.signals):
        for k in range(signal.size):
            if signal.role in _ROWS:
                source = _ROWS[signal.role].format(k=k)
            elif signal.role is b.Role.DRIVE_STATE:
                source = f"sensed[{states.index(signal.channel)}, {k}]"
            elif signal.role is b.Role.EXTERNAL:
                source = f"aux[{channels.index(signal.channel)}]"
            else:
                continue
            lines.append(f"s{number}_{k} = {source}")
    return lines


def _channels(diagram: b.Diagram) -> tuple[str, ...]:
    every = [one.channel for one in diagram.signals if one.role is b.Role.EXTERNAL]
    return tuple(dict.fromkeys(every))


def _identifier(name: str) -> str:
    """Return a name as part of the name of a module."""
    kept = "".join(one if one.isascii() and one.isalnum() else "_" for one in name[:40])
    return f"diagram_{kept or 'law'}"
