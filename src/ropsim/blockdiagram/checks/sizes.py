"""Checks of sizes: inputs, lists of numbers and matrices of each block."""

from collections.abc import Iterator, Sequence

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.checks.fault import CONTROLLER, Fault, Part, blocks_of, called
from ropsim.blockdiagram.diagnostics import WRONG_SIZE
from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.fields import FieldKind, Trait
from ropsim.blockdiagram.forms import FORM_OF
from ropsim.blockdiagram.signals import PER_AXIS


def size_faults(diagram: Diagram) -> Iterator[Fault]:
    """Yield faults in sizes of signals from outside and of blocks; names are right."""
    sizes = {one.name: one.size for one in diagram.signals}
    axes = diagram.axes
    for number, signal in enumerate(diagram.signals):
        if signal.role in PER_AXIS and signal.size != axes:
            message = (
                f"signal `{signal.name[:60]}` has {signal.size} elements; allowed are {axes}, one an axis"
            )
            yield Fault(WRONG_SIZE, ("signal", number), message)
    for part, block in blocks_of(diagram):
        inputs = [sizes[name] for name in block.inputs]
        yield from _inputs(part, block, inputs, sizes[block.output], axes)
        yield from _lists(part, block, sizes[block.output])
        if isinstance(block, b.MatrixGain):
            yield from _matrix(part, block, "matrix", block.matrix, (sizes[block.output], sum(inputs)))
        elif isinstance(block, b.StateSpace):
            yield from _state_space(part, block, sum(inputs), sizes[block.output])
    holder = next((one for one in diagram.blocks if one.name == diagram.holding), None)
    if holder is not None and not (isinstance(holder, b.Pid | b.Integrator) and sizes[holder.output] == axes):
        message = f"{called(holder)} is to hold the arm; allowed is a PID block or an integrator"
        yield Fault(WRONG_SIZE, CONTROLLER, f"{message} with an element for each axis")


def _inputs(part: Part, block: b.Block, inputs: list[int], size: int, axes: int) -> Iterator[Fault]:
    form = FORM_OF[type(block)]
    least, most = form.inputs
    if isinstance(block, b.ModelFeedForward):
        least, most = (1, 1) if block.kind is b.ModelKind.GRAVITY else (3, 4)
    if not least <= len(inputs) <= most:
        allowed = str(least) if least == most else f"{least} to {most}"
        yield Fault(WRONG_SIZE, part, f"{called(block)} has {len(inputs)} inputs, allowed are {allowed}")
    elif Trait.ELEMENTWISE in form.traits and any(one != size for one in inputs):
        wrong = next(one for one in inputs if one != size)
        message = f"{called(block)} has an input of {wrong} elements and an output of {size}"
        yield Fault(WRONG_SIZE, part, message, "it works element by element: both have equal sizes")
    elif isinstance(block, b.Switch) and (inputs[0] not in (1, size) or inputs[1:] != [size, size]):
        message = f"{called(block)} has inputs of {inputs} elements and an output of {size}"
        yield Fault(WRONG_SIZE, part, message, "choices have the size of the output, the condition this or 1")
    elif isinstance(block, b.ModelFeedForward | b.DriveCommand) and {*inputs, size} != {axes}:
        message = f"{called(block)} has inputs of {inputs} elements and an output of {size}"
        yield Fault(WRONG_SIZE, part, message, f"each has an element for each of the {axes} axes")


def _lists(part: Part, block: b.Block, size: int) -> Iterator[Fault]:
    form = FORM_OF[type(block)]
    for name, kind in form.fields:
        values = getattr(block, name)
        if kind is FieldKind.INTEGERS and len(values) != len(block.inputs):
            message = f"{called(block)} has {len(values)} signs for {len(block.inputs)} inputs"
            yield Fault(WRONG_SIZE, part, message)
        if kind not in (FieldKind.REALS, FieldKind.OPTIONAL_REALS) or name in form.whole:
            continue
        if len(values) not in (1, size) and not (kind is FieldKind.OPTIONAL_REALS and not values):
            message = f"`{name}` of {called(block)} has {len(values)} numbers; allowed are 1 or {size}"
            yield Fault(WRONG_SIZE, part, message)


def _state_space(part: Part, block: b.StateSpace, inputs: int, size: int) -> Iterator[Fault]:
    states = len(block.a)
    shapes = {"a": (states, states), "b": (states, inputs), "c": (size, states), "d": (size, inputs)}
    for name, shape in shapes.items():
        yield from _matrix(part, block, name, getattr(block, name), shape)
    if block.x0 and len(block.x0) != states:
        message = f"`x0` of {called(block)} has {len(block.x0)} numbers; allowed are {states}"
        yield Fault(WRONG_SIZE, part, message)


def _matrix(
    part: Part, block: b.Block, name: str, rows: Sequence[Sequence[float]], shape: tuple[int, int]
) -> Iterator[Fault]:
    if len(rows) != shape[0] or any(len(row) != shape[1] for row in rows):
        columns = (
            "rows of unequal length"
            if len({len(row) for row in rows}) > 1
            else f"{len(rows[0]) if rows else 0} columns"
        )
        message = f"`{name}` of {called(block)} has {len(rows)} rows and {columns}"
        yield Fault(WRONG_SIZE, part, f"{message}; allowed are {shape[0]} rows and {shape[1]} columns")
