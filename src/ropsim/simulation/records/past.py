"""Where an arm was at each control tick of its immediate past, for others that have not come so far yet."""

from collections import deque

import numpy as np

from ropsim.spatial import Array


class Past:
    """Joint coordinates at every control tick from the first tick that others may still request.

    A station computes a whole move at a time and is ahead of the others then; their actions on a part in its
    gripper need its pose at their tick. Recorded rows are too coarse for that, and their number must not
    affect results.

    Args:
        tick: control tick at which it begins.
        q: joint coordinates there [rad | m], shape (n,).
    """

    def __init__(self, tick: int, q: Array) -> None:
        self._blocks = deque([(tick, q[None])])

    def enter(self, tick: int, q: Array) -> None:
        """Take the coordinates at the next ticks, shape (k, n), the first of them at `tick`."""
        self._blocks.append((tick, q))

    def forget(self, tick: int) -> None:
        """Drop whole entries before a tick."""
        while len(self._blocks) > 1 and self._blocks[1][0] <= tick:
            self._blocks.popleft()

    def at(self, tick: float) -> Array:
        """Return the coordinates at a tick [rad | m], shape (n,): between two ticks linear.

        Before the first tick that is kept, and after the last one, the value of that tick is returned.
        """
        whole = int(tick // 1)
        before, share = self._row(whole), tick - whole
        return np.asarray(before + share * (self._row(whole + 1) - before)) if share else before

    def _row(self, tick: int) -> Array:
        known = (block for block in reversed(self._blocks) if block[0] <= tick)
        first, q = next(known, self._blocks[0])
        row: Array = q[min(max(tick - first, 0), len(q) - 1)]
        return row
