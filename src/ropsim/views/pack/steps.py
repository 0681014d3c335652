"""Held quantities of a pack: values that change at once and hold, with the exact times of their changes."""

import numpy as np

from ropsim.flow import Recording
from ropsim.spatial import Array
from ropsim.views.pack.columns import Code

HELD = ("line", "move", "gripper", "payload")
"""Channels that hold their values; so do all signals."""


def is_held(name: str) -> bool:
    """Return whether a channel of this name holds its values between changes."""
    return name in HELD or name.startswith("signal.")


def steps(values: Array, recording: Recording) -> Code:
    """Return the code of a held column.

    A recording has rows at some control ticks only: a change lies between the last row with the old value
    and the first one with the new. It happens when an instruction begins or ends, so the latest such time
    in between is taken, else that of the last row with the old value.

    Args:
        values: shape (n,), one per row of the recording.
        recording: gives times of rows and events.
    """
    same = (values[1:] == values[:-1]) | (np.isnan(values[1:]) & np.isnan(values[:-1]))
    rows = np.flatnonzero(~same) + 1
    if not len(rows):
        return {"kind": "constant", "value": _number(values[0])}
    known = event_times(recording)
    before, at = np.round(recording.time[rows - 1], DECIMALS), recording.time[rows]
    latest = np.searchsorted(known, at - _TICK) - 1
    exact = np.where(latest >= 0, known[np.maximum(latest, 0)], -np.inf) if len(known) else before
    times = np.where(exact >= before - _TICK, np.maximum(exact, before), before)
    return {
        "kind": "steps",
        "times": [float(recording.time[0]), *times.tolist()],
        "values": [_number(value) for value in values[np.concatenate([[0], rows])]],
    }


DECIMALS = 9
"""Times of rows and events are whole ticks divided by the rate; this is far above their rounding."""

_TICK = 1e-9


def event_times(recording: Recording) -> Array:
    """Return all times at which an instruction began or ended [s], ascending."""
    times = [time for event in recording.events for time in (event.time, event.time + event.duration)]
    return np.unique(np.round(np.array(times, dtype=np.float64), DECIMALS))


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
