"""How fast the TCP goes along paths whose frame external axes move: against that frame, not in the room."""

from collections.abc import Sequence

import numpy as np

from ropsim.simulation.records.move_span import PathSpan
from ropsim.spatial import Array


def path_speeds(paths: Sequence[PathSpan], times: Array, ticks: Array, q: Array, positions: Array) -> Array:
    """Return the speed of the TCP against the frame of its path, by central differences [m/s], shape (k,).

    NaN where external axes move no frame of a path, and the speed is that in the base frame.

    Args:
        paths: as followed, in order of time.
        times: of the recorded rows [s], shape (k,).
        ticks: the same in control ticks, shape (k,).
        q: joint coordinates [rad | m], shape (k, n).
        positions: of the TCP in the base frame [m], shape (k, 3).
    """
    speeds = np.full(len(ticks), np.nan)
    for span in paths:
        first, last = np.searchsorted(ticks, [span.start, span.end], side="right")
        if span.frame is None or last - first < 2:
            continue
        seen = span.frame.positions(q[first:last], positions[first:last])
        speeds[first:last] = np.linalg.norm(np.gradient(seen, times[first:last], axis=0), axis=1)
    return speeds
