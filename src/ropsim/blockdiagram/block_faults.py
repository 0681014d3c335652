"""What the numbers of blocks must not be, block by block; they are finite, and their sizes right."""

from collections.abc import Iterator
from itertools import pairwise

from ropsim.blockdiagram import blocks as b

MOST_TICKS = 1000
"""Longest delay, and longest moving mean [control ticks]."""
MOST_ORDER = 50
"""Greatest order of a transfer function."""
_HALF_RATE = 3.1
"""Frequency of a notch times the period, a little below π."""
_FEWEST = 2  # points of a table


def sum_faults(block: b.Sum) -> Iterator[str]:
    """Yield signs that are none."""
    if not set(block.signs) <= {1, -1}:
        yield "signs must be 1 or -1"


def rate_faults(block: b.RateLimiter) -> Iterator[str]:
    """Yield bounds with a wrong sign."""
    if max(block.falling) >= 0.0 or min(block.rising) <= 0.0:
        yield "`falling` must be negative and `rising` positive"


def tick_faults(block: b.Delay | b.MovingFilter) -> Iterator[str]:
    """Yield numbers of control ticks that are too small or too large."""
    if not 1 <= block.ticks <= MOST_TICKS:
        yield f"`ticks` is {block.ticks}; allowed are 1 to {MOST_TICKS}"


def notch_faults(block: b.Notch) -> Iterator[str]:
    """Yield a frequency, a damping or a depth that cannot be."""
    if not 0.0 < block.frequency * block.sample_time < _HALF_RATE:
        yield f"{block.frequency:g} rad/s is not below half of the control rate"
    if not (block.damping > 0.0 and 0.0 <= block.depth <= 1.0):
        yield "`damping` must be positive and `depth` from 0 to 1"


def point_faults(block: b.Lookup) -> Iterator[str]:
    """Yield points that are no table."""
    if len(block.points) != len(block.values) or len(block.points) < _FEWEST:
        found = f"it has {len(block.points)} points and {len(block.values)} values"
        yield f"{found}; allowed are two or more of both"
    elif any(not low < high for low, high in pairwise(block.points)):
        yield "`points` must rise"


def limit_faults(block: b.Saturation | b.DeadBand | b.Pid) -> Iterator[str]:
    """Yield limits that leave nothing between them, or one without the other."""
    lower, upper = block.lower, block.upper
    if bool(lower) is not bool(upper):
        yield "it has one of `lower` and `upper`; allowed are both or none"
    elif lower and any(
        not low < high for low, high in zip(_all(lower, upper), _all(upper, lower), strict=True)
    ):
        yield "`lower` must be below `upper`"


def pid_faults(block: b.Pid) -> Iterator[str]:
    """Yield limits, times and a way against windup that do not go together."""
    yield from limit_faults(block)
    if any(one < 0.0 for one in block.derivative_filter):
        yield "`derivative_filter` must not be negative"
    if block.anti_windup is not b.AntiWindup.NONE and not block.lower:
        yield f"`{block.anti_windup}` needs `lower` and `upper`"
    needed = block.anti_windup is b.AntiWindup.BACK_CALCULATION
    if needed is not bool(block.tracking_time) or any(one <= 0.0 for one in block.tracking_time):
        yield "`tracking_time` must be positive, and belongs to `back_calculation` alone"


def _all(values: b.Numbers, others: b.Numbers) -> b.Numbers:
    return values * len(others) if len(values) == 1 else values


def transfer_function_faults(block: b.TransferFunction) -> Iterator[str]:
    """Yield polynomials that are no proper transfer function."""
    if not block.denominator or not block.numerator:
        yield "numerator and denominator must have a number"
    elif block.denominator[0] == 0.0:
        yield "the first number of the denominator must not be 0"
    elif len(block.numerator) > len(block.denominator):
        yield "the numerator must not be longer than the denominator"
    elif len(block.denominator) > MOST_ORDER + 1:
        yield f"its order is {len(block.denominator) - 1}; allowed are orders up to {MOST_ORDER}"
