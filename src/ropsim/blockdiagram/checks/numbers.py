"""Checks of the numbers of blocks."""

from collections.abc import Iterable, Iterator
from itertools import pairwise
from math import isfinite

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.checks.fault import CONTROLLER, Fault, blocks_of, called
from ropsim.blockdiagram.diagnostics import WRONG_NUMBER
from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.fields import FORM_OF, FieldKind

LARGEST = 1e12
"""No number of a diagram is larger; products of two of them stay finite."""
MOST_TICKS = 1000
"""Longest delay, and longest moving mean [control ticks]."""
MOST_ORDER = 50
"""Greatest order of a transfer function."""
_HALF_RATE = 3.1
"""Frequency of a notch times the period, a little below π."""
_FEWEST = 2  # points of a table
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
        for wrong in _faults(block):
            yield Fault(WRONG_NUMBER, part, f"{called(block)}: {wrong}")
        products += sum(
            value != 0.0 for name, value in _numbers(block) if name in ("matrix", "a", "b", "c", "d")
        )
    if products > MOST_PRODUCTS:
        message = f"matrices have {products} numbers that are not 0; allowed are {MOST_PRODUCTS}"
        yield Fault(WRONG_NUMBER, CONTROLLER, message)


def _numbers(block: b.Block) -> Iterable[tuple[str, float]]:
    for name, kind in FORM_OF[type(block)].fields:
        value = getattr(block, name)
        if kind is FieldKind.REAL:
            yield name, value
        elif kind in (FieldKind.REALS, FieldKind.OPTIONAL_REALS):
            yield from ((name, one) for one in value)
        elif kind is FieldKind.MATRIX:
            yield from ((name, one) for row in value for one in row)


def _faults(block: b.Block) -> Iterator[str]:
    match block:
        case b.Saturation() | b.DeadBand() | b.Pid():
            yield from _limits(block)
        case b.RateLimiter():
            if max(block.falling) >= 0.0 or min(block.rising) <= 0.0:
                yield "`falling` must be negative and `rising` positive"
        case b.Delay() | b.MovingFilter():
            if not 1 <= block.ticks <= MOST_TICKS:
                yield f"`ticks` is {block.ticks}; allowed are 1 to {MOST_TICKS}"
        case b.Lookup():
            yield from _points(block)
        case b.TransferFunction():
            yield from _transfer_function(block)
        case b.Notch():
            if not 0.0 < block.frequency * block.sample_time < _HALF_RATE:
                yield f"{block.frequency:g} rad/s is not below half of the control rate"
            if not (block.damping > 0.0 and 0.0 <= block.depth <= 1.0):
                yield "`damping` must be positive and `depth` from 0 to 1"
        case b.Sum():
            if not set(block.signs) <= {1, -1}:
                yield "signs must be 1 or -1"
        case _:
            pass


def _points(block: b.Lookup) -> Iterator[str]:
    if len(block.points) != len(block.values) or len(block.points) < _FEWEST:
        found = f"it has {len(block.points)} points and {len(block.values)} values"
        yield f"{found}; allowed are two or more of both"
    elif any(not low < high for low, high in pairwise(block.points)):
        yield "`points` must rise"


def _limits(block: b.Saturation | b.DeadBand | b.Pid) -> Iterator[str]:
    lower, upper = block.lower, block.upper
    if bool(lower) is not bool(upper):
        yield "it has one of `lower` and `upper`; allowed are both or none"
    elif lower and any(
        not low < high for low, high in zip(_all(lower, upper), _all(upper, lower), strict=True)
    ):
        yield "`lower` must be below `upper`"
    if isinstance(block, b.Pid):
        if any(one < 0.0 for one in block.derivative_filter):
            yield "`derivative_filter` must not be negative"
        if block.anti_windup is not b.AntiWindup.NONE and not lower:
            yield f"`{block.anti_windup}` needs `lower` and `upper`"
        needed = block.anti_windup is b.AntiWindup.BACK_CALCULATION
        if needed is not bool(block.tracking_time) or any(one <= 0.0 for one in block.tracking_time):
            yield "`tracking_time` must be positive, and belongs to `back_calculation` alone"


def _all(values: b.Numbers, others: b.Numbers) -> b.Numbers:
    return values * len(others) if len(values) == 1 else values


def _transfer_function(block: b.TransferFunction) -> Iterator[str]:
    if not block.denominator or not block.numerator:
        yield "numerator and denominator must have a number"
    elif block.denominator[0] == 0.0:
        yield "the first number of the denominator must not be 0"
    elif len(block.numerator) > len(block.denominator):
        yield "the numerator must not be longer than the denominator"
    elif len(block.denominator) > MOST_ORDER + 1:
        yield f"its order is {len(block.denominator) - 1}; allowed are orders up to {MOST_ORDER}"
