"""Axis ticks at nice numbers: 1, 2 or 5 times a power of ten."""

import math


def nice_ticks(low: float, high: float, count: int) -> tuple[float, ...]:
    """Return about `count` nice numbers inside [low, high], ascending; empty for an empty range."""
    if not (math.isfinite(low) and math.isfinite(high)) or high <= low or count < 1:
        return ()
    step = nice_step((high - low) / count)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return tuple(k * step for k in range(first, last + 1))


def nice_step(raw: float) -> float:
    """Return the smallest of 1, 2, 5, 10 times a power of ten that is at least `raw` (> 0)."""
    power = 10.0 ** math.floor(math.log10(raw))
    for factor in (1.0, 2.0, 5.0):
        if factor * power >= raw * (1.0 - 1e-9):
            return factor * power
    return 10.0 * power


def tick_text(value: float, ticks: tuple[float, ...]) -> str:
    """Return a tick with just the decimals that the distance of the ticks needs."""
    step = abs(ticks[1] - ticks[0]) if len(ticks) > 1 else abs(value) or 1.0
    decimals = max(0, -math.floor(math.log10(step) + 1e-9))
    return f"{value:.{decimals}f}" if decimals <= 6 else f"{value:.1e}"


def padded(low: float, high: float) -> tuple[float, float]:
    """Return a range with 6 % of room on both sides; a range without extent gets some."""
    room = 0.06 * (high - low) or abs(high) * 0.1 or 1.0
    return low - room, high + room
