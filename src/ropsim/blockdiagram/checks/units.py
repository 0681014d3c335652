"""Checks of units, element by element."""

from collections.abc import Iterator, Sequence

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.checks.fault import Fault, Part, blocks_of, called
from ropsim.blockdiagram.diagnostics import WRONG_UNIT
from ropsim.blockdiagram.diagram import Diagram, OutputKind
from ropsim.blockdiagram.fields import Trait
from ropsim.blockdiagram.forms import FORM_OF
from ropsim.blockdiagram.signals import SLIDING, TURNING, Role, Signal, Unit

_OUTPUTS = {
    OutputKind.VOLTAGE: (Unit.VOLT,),
    OutputKind.EFFORT: (Unit.NEWTON_METRE, Unit.NEWTON),
    OutputKind.VALVE_CURRENT: (Unit.AMPERE,),
    OutputKind.DRIVE_INPUT: tuple(Unit),
}
_MOTION = (Role.COORDINATE, Role.SPEED, Role.REFERENCE_ACCELERATION, Role.SPEED)
"""Roles whose units inputs of the model of the arm have."""


def unit_faults(diagram: Diagram) -> Iterator[Fault]:
    """Yield units that do not go together; sizes are right."""
    known = {one.name: one for one in diagram.signals}
    for number, signal in enumerate(diagram.signals):
        allowed: Sequence[Unit] = tuple(Unit)
        if signal.role in TURNING:
            allowed = (TURNING[signal.role], SLIDING[signal.role])
        elif signal.role is Role.OUTPUT:
            allowed = _OUTPUTS[diagram.output_kind]
        wrong = [one for one in signal.units if one not in allowed]
        if wrong:
            message = f"signal `{signal.name[:60]}` with the role `{signal.role}` is in `{wrong[0]}`"
            words = " or ".join(f"`{one}`" for one in allowed)
            yield Fault(WRONG_UNIT, ("signal", number), f"{message}; allowed is {words}")
    for part, block in blocks_of(diagram):
        inputs = [known[name] for name in block.inputs]
        yield from _block(part, block, inputs, known[block.output])
    for number, link in enumerate(diagram.links):
        source, target = known[link.source], known[link.target]
        for k in range(link.count):
            pair = source.unit(link.source_first + k), target.unit(link.target_first + k)
            if _differ(*pair):
                message = f"a link leads from `{source.name[:60]}` in `{pair[0]}` to `{target.name[:60]}`"
                yield Fault(WRONG_UNIT, ("link", number), f"{message} in `{pair[1]}`")
                break


def _block(part: Part, block: b.Block, inputs: list[Signal], output: Signal) -> Iterator[Fault]:
    equal: list[Signal] = []
    if Trait.KEEPS_UNITS in FORM_OF[type(block)].traits:
        equal = [*inputs, output]
    elif isinstance(block, b.Switch):
        equal = [*inputs[1:], output]
    elif isinstance(block, b.Pid):
        equal = inputs[:2]
        if len(inputs) == 3:
            yield from _equal(part, block, [inputs[2], output])
    yield from _equal(part, block, equal)
    if isinstance(block, b.ModelFeedForward | b.DriveCommand):
        roles = _MOTION if isinstance(block, b.ModelFeedForward) else (Role.EFFORT, Role.SPEED)
        for signal, role in zip(inputs, roles, strict=False):
            yield from _of_axes(part, block, signal, role)
        if isinstance(block, b.ModelFeedForward):
            yield from _of_axes(part, block, output, Role.EFFORT)


def _equal(part: Part, block: b.Block, signals: list[Signal]) -> Iterator[Fault]:
    for one in signals[1:]:
        for k in range(one.size):
            if _differ(signals[0].unit(k), one.unit(k)):
                first = f"`{signals[0].name[:60]}` in `{signals[0].unit(k)}`"
                pair = f"{first} and `{one.name[:60]}` in `{one.unit(k)}`"
                yield Fault(WRONG_UNIT, part, f"{called(block)} has {pair} in element {k + 1}")
                return


def _of_axes(part: Part, block: b.Block, signal: Signal, role: Role) -> Iterator[Fault]:
    allowed = (TURNING[role], SLIDING[role], Unit.OTHER)
    wrong = [one for one in signal.units if one not in allowed]
    if wrong:
        message = f"{called(block)} has signal `{signal.name[:60]}` in `{wrong[0]}`"
        yield Fault(WRONG_UNIT, part, f"{message}; allowed is `{allowed[0]}` or `{allowed[1]}`")


def _differ(one: Unit, other: Unit) -> bool:
    return one is not other and Unit.OTHER not in (one, other)
