"""Checks of the numbers of blocks."""

from collections.abc import Iterable, Iterator
from math import isfinite

from ropsim.blockdiagram.block_faults import MOST_TICKS
from ropsim.blockdiagram.blocks import Block
from ropsim.blockdiagram.checks.fault import CONTROLLER, Fault, blocks_of, called
from ropsim.blockdiagram.diagnostics import WRONG_NUMBER
from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.fields import FieldKind
from ropsim.blockdiagram.forms import FORM_OF

LARGEST = 1e12
"""No number of a diagram is larger; products of two of them stay finite."""
MOST_PRODUCTS = 20_000
"""Numbers of all matrices that are not 0: each is a product at every tick."""


def number_faults(diagram: Diagram) -> Iterator[Fault]:
    """Yield numbers that cannot be; sizes are right."""
    if not 0.0 < diagram.period <= LARGEST:
        yield Fault(
            WRONG_NUMBER, CONTROLLER, f"the period is {diagram.period:g} s; allowed are positive times"
        )
    if not 0 <= diagram.delay <= MOST_TICKS:
        message = f"the delay is {diagram.delay} control ticks; allowed are 0 to {MOST_TICKS}"
        yield Fault(WRONG_NUMBER, CONTROLLER, message)
    products = 0
    for part, block in blocks_of(diagram):
        unlike = [name for name, value in _numbers(block) if not (isfinite(value) and abs(value) <= LARGEST)]
        if unlike:
            message = (
                f"`{unlike[0]}` of {called(block)} has a number beyond {LARGEST:g}, or none that is finite"
            )
            yield Fault(WRONG_NUMBER, part, message)
            continue
        time = getattr(block, "sample_time", diagram.period)
        if time != diagram.period:
            message = f"the sample time of {called(block)} is {time:g} s, the period {diagram.period:g} s"
            yield Fault(WRONG_NUMBER, part, message, "all blocks run at the period of the controller")
        for wrong in FORM_OF[type(block)].faults(block):
            yield Fault(WRONG_NUMBER, part, f"{called(block)}: {wrong}")
        products += sum(
            value != 0.0 for name, value in _numbers(block) if name in ("matrix", "a", "b", "c", "d")
        )
    if products > MOST_PRODUCTS:
        message = f"matrices have {products} numbers that are not 0; allowed are {MOST_PRODUCTS}"
        yield Fault(WRONG_NUMBER, CONTROLLER, message)


def _numbers(block: Block) -> Iterable[tuple[str, float]]:
    for name, kind in FORM_OF[type(block)].fields:
        value = getattr(block, name)
        if kind is FieldKind.REAL:
            yield name, value
        elif kind in (FieldKind.REALS, FieldKind.OPTIONAL_REALS):
            yield from ((name, one) for one in value)
        elif kind is FieldKind.MATRIX:
            yield from ((name, one) for row in value for one in row)
