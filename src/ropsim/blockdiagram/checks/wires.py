"""Checks of names and of wiring: every element is set once."""

from collections import Counter
from collections.abc import Iterator

from ropsim.blockdiagram.checks.fault import CONTROLLER, Fault, Part, blocks_of, called
from ropsim.blockdiagram.diagnostics import WRONG_NUMBER, WRONG_SIZE, WRONG_WIRING
from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.signals import CHANNELED, INPUTS, Role
from ropsim.core import did_you_mean

MOST_ELEMENTS = 4000
"""Elements of all signals of a diagram."""


def name_faults(diagram: Diagram) -> Iterator[Fault]:
    """Yield names that are used twice or that nothing has, and signals that cannot be."""
    yield from _signal_faults(diagram)
    signals = {one.name for one in diagram.signals}
    names = Counter(one.name for one in diagram.blocks)
    for part, block in blocks_of(diagram):
        if names[block.name] > 1:
            yield Fault(WRONG_WIRING, part, f"{names[block.name]} blocks are called `{block.name[:60]}`")
        for name in (*block.inputs, block.output):
            if name not in signals:
                yield _unknown(part, called(block), name, diagram)
    for number, link in enumerate(diagram.links):
        for name in (link.source, link.target):
            if name not in signals:
                yield _unknown(("link", number), "a link", name, diagram)
    if diagram.holding and diagram.holding not in names:
        message = f"`{diagram.holding[:60]}` is to hold the arm and is no block"
        yield Fault(WRONG_WIRING, CONTROLLER, message, did_you_mean(diagram.holding, names))


def _signal_faults(diagram: Diagram) -> Iterator[Fault]:
    signals = Counter(one.name for one in diagram.signals)
    for number, signal in enumerate(diagram.signals):
        part = ("signal", number)
        if signals[signal.name] > 1:
            yield Fault(WRONG_WIRING, part, f"{signals[signal.name]} signals are called `{signal.name[:60]}`")
        if signal.size < 1 or len(signal.units) not in (1, signal.size):
            found = f"signal `{signal.name[:60]}` has {signal.size} elements and {len(signal.units)} units"
            yield Fault(WRONG_SIZE, part, f"{found}; allowed are one unit, or one for each element")
        if bool(signal.channel) is not (signal.role in CHANNELED):
            needs = "needs a channel" if signal.role in CHANNELED else "takes no channel"
            message = f"signal `{signal.name[:60]}` with the role `{signal.role}` {needs}"
            yield Fault(WRONG_WIRING, part, message)
    total = sum(one.size for one in diagram.signals)
    if total > MOST_ELEMENTS:
        message = f"the signals have {total} elements in all, allowed are {MOST_ELEMENTS}"
        yield Fault(WRONG_NUMBER, CONTROLLER, message)
    outputs = sum(one.role is Role.OUTPUT for one in diagram.signals)
    if outputs != 1:
        message = f"{outputs} signals have the role `output`, allowed is one"
        yield Fault(WRONG_WIRING, CONTROLLER, message)


def _unknown(part: Part, who: str, name: str, diagram: Diagram) -> Fault:
    hint = did_you_mean(name, [one.name for one in diagram.signals])
    return Fault(WRONG_WIRING, part, f"{who} has signal `{name[:60]}`, which is not there", hint)


def wire_faults(diagram: Diagram) -> Iterator[Fault]:
    """Yield elements that are set by nothing, twice, or though they come from outside; names are right."""
    known = {one.name: one for one in diagram.signals}
    setters: dict[tuple[str, int], int] = {}
    for part, block in blocks_of(diagram):
        yield from _setting(
            part,
            called(block),
            [(block.output, k) for k in range(known[block.output].size)],
            setters,
            diagram,
        )
    for number, link in enumerate(diagram.links):
        part = ("link", number)
        ends = (link.source, link.source_first), (link.target, link.target_first)
        if any(not 0 <= first <= known[name].size - link.count for name, first in ends) or link.count < 1:
            message = f"a link from `{link.source[:60]}` to `{link.target[:60]}` leads beyond their elements"
            yield Fault(WRONG_SIZE, part, message)
            continue
        elements = [(link.target, link.target_first + k) for k in range(link.count)]
        yield from _setting(part, "a link", elements, setters, diagram)
    for number, signal in enumerate(diagram.signals):
        missing = [k + 1 for k in range(signal.size) if (signal.name, k) not in setters]
        if signal.role not in INPUTS and missing:
            which = "" if len(missing) == signal.size else f" in element {missing[0]}"
            message = f"signal `{signal.name[:60]}` is set by nothing{which}"
            yield Fault(WRONG_WIRING, ("signal", number), message, "let a block or a link set it")


def _setting(
    part: Part,
    who: str,
    elements: list[tuple[str, int]],
    setters: dict[tuple[str, int], int],
    diagram: Diagram,
) -> Iterator[Fault]:
    """Note who sets elements; yield one fault where they are set already or come from outside."""
    name = elements[0][0]
    signal = next(one for one in diagram.signals if one.name == name)
    if signal.role in INPUTS:
        message = f"{who} sets signal `{name[:60]}`, which comes from outside as `{signal.role}`"
        yield Fault(WRONG_WIRING, part, message)
        return
    if any(element in setters for element in elements):
        yield Fault(WRONG_WIRING, part, f"{who} sets signal `{name[:60]}`, which is set already")
    setters.update(dict.fromkeys(elements, 1))
