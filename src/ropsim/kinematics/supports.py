"""Supports: what a part stands on, and what it is in.

A part is looked at along vertical lines through its footprint. The gap on a line is the height of its lower
end above the upper end of what is below. The floor is the plane z = 0 of the world.
"""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.kinematics.blocks import Blocks, Rows
from ropsim.model import WORLD
from ropsim.spatial import Array

LINES = 7
"""Lines along each side of the footprint."""
INSET = 0.002
"""The outermost lines are so far within the footprint [m]: what touches a part at its side is not below."""
TOUCH = 1e-9
"""Up to this depth bodies touch: it is the rounding of poses [m]."""
HANDFUL = 256
"""So many pairs are looked at together: what that takes fits into the processor's cache."""
FEW = 4
"""Fewer parts than this are compared with everything."""
MOST_CELLS = 256
"""What covers more cells of the grid than this is compared with every part."""


@frozen_dataclass
class Standing:
    """How a part stands.

    Attributes:
        on: name of the body that carries it, `WORLD` for the floor, None where nothing does.
        inside: name of the body in which it is the deepest, empty for none.
        depth: how much higher it would be free of that body [m]; 0 for none.
    """

    on: str | None
    inside: str = ""
    depth: float = 0.0


def standings(parts: Blocks, others: Blocks, gap: float) -> list[Standing]:
    """Return how each part stands.

    Args:
        parts: one block for each part.
        others: all that can carry; a part that is among them does not carry itself.
        gap: greatest height above a support that counts as standing on it [m].
    """
    found = [_Found() for _ in parts.owners]
    for rows, cols in _batches(*_near(parts, others, gap)):
        least, depth = _gaps(parts, others, rows, cols)
        for k, i in enumerate(rows.tolist()):
            found[i].meet(others.owners[cols[k]], float(least[k]), float(depth[k]), gap)
    heights = parts.reaches[0][:, 2].tolist()
    return [one.standing(height, gap) for one, height in zip(found, heights, strict=True)]


def height_above(parts: Blocks, row: int, others: Blocks) -> tuple[float, str]:
    """Return the height of a part above what is next below it [m], and its name: `WORLD` for the floor.

    The floor is meant below it only where nothing else is: the height is negative then.
    """
    rows, cols = np.full(len(others.owners), row), np.arange(len(others.owners))
    least, _ = _gaps(parts, others, rows, cols)
    own = parts.owners[row]
    near = [
        (float(one), name)
        for one, name in zip(least, others.owners, strict=True)
        if name != own and np.isfinite(one)
    ]
    floor = float(parts.reaches[0][row, 2])
    if floor >= 0.0 or not near:
        near.append((floor, WORLD))
    return min(near, key=lambda one: (max(one[0], 0.0), one[1]))


@dataclass(slots=True)
class _Found:
    """What has been found below one part so far."""

    on: str | None = None
    least: float = np.inf
    inside: str = ""
    depth: float = 0.0

    def meet(self, name: str, least: float, depth: float, gap: float) -> None:
        if least <= gap and abs(least) < self.least:
            self.on, self.least = name, abs(least)
        if depth > max(self.depth, TOUCH):
            self.inside, self.depth = name, depth

    def standing(self, height: float, gap: float) -> Standing:
        on = WORLD if self.on is None and abs(height) <= gap else self.on
        return Standing(on, self.inside, self.depth)


def _gaps(parts: Blocks, others: Blocks, rows: Rows, cols: Rows) -> tuple[Array, Array]:
    """Return for pairs of a part and something else the least gap [m] and the greatest depth [m], shape (p,).

    The gap is infinite where the other is not below: it must begin lower than the part, as a whole and on the
    line. The depth is 0 where they do not meet.
    """
    low, high = (edge[rows] for edge in parts.reaches)
    lines = _lines(low[:, :2], high[:, :2])
    bottom, upper = parts.spans(rows, lines)
    beneath, top = others.spans(cols, lines)
    gaps = bottom - top
    lower = others.reaches[0][cols, 2] < low[:, 2]
    least = np.where((beneath < bottom) & lower[:, np.newaxis], gaps, np.inf)
    depth = np.where((gaps < 0.0) & (upper > beneath), -gaps, 0.0)
    return least.min(axis=1, initial=np.inf), depth.max(axis=1, initial=0.0)


def _lines(low: Array, high: Array) -> Array:
    """Return x and y of the lines through footprints with corners (k, 2) [m], shape (k, LINES², 2)."""
    inset = np.minimum(INSET, 0.1 * (high - low))
    share = np.linspace(0.0, 1.0, LINES)
    along = (low + inset)[:, :, np.newaxis] + (high - low - 2.0 * inset)[:, :, np.newaxis] * share
    grid = np.broadcast_arrays(along[:, 0, :, np.newaxis], along[:, 1, np.newaxis, :])
    return np.stack(grid, axis=-1).reshape(len(low), LINES * LINES, 2)


def _batches(rows: Rows, cols: Rows) -> Iterator[tuple[Rows, Rows]]:
    """Yield pairs in handfuls, so that no array gets large."""
    for first in range(0, len(rows), HANDFUL):
        yield rows[first : first + HANDFUL], cols[first : first + HANDFUL]


def _near(parts: Blocks, others: Blocks, gap: float) -> tuple[Rows, Rows]:
    """Return the pairs (part, other) whose boxes along x, y, z meet or lie at most `gap` apart, in order."""
    low, high = parts.reaches
    low_others, high_others = others.reaches
    if not len(low) or not len(low_others):
        return np.empty(0, np.intp), np.empty(0, np.intp)
    rows, cols = (_every_pair if len(low) < FEW else _side_by_side)(parts, others)
    meets = (low_others[cols] <= high[rows]).all(axis=1) & (high_others[cols, :2] >= low[rows, :2]).all(
        axis=1
    )
    meets &= high_others[cols, 2] >= low[rows, 2] - gap
    meets &= np.array(others.owners)[cols] != np.array(parts.owners)[rows]
    return rows[meets], cols[meets]


def _every_pair(parts: Blocks, others: Blocks) -> tuple[Rows, Rows]:
    """Return all pairs (part, other), in order."""
    rows, cols = np.indices((len(parts.owners), len(others.owners))).reshape(2, -1)
    return rows, cols


def _side_by_side(parts: Blocks, others: Blocks) -> tuple[Rows, Rows]:
    """Return the pairs (part, other) whose footprints may meet, in order.

    Footprints are entered into a grid whose cells are as large as half of the parts, so that a part is only
    compared with what is in its own cells.
    """
    low, high = parts.reaches
    low_others, high_others = others.reaches
    widths = np.sort(high[:, :2] - low[:, :2], axis=None)
    cell = max(float(widths[len(widths) // 2]), 1e-3)
    count = np.floor(high_others[:, :2] / cell) - np.floor(low_others[:, :2] / cell) + 1.0
    wide = np.prod(count, axis=1) > MOST_CELLS
    slim = np.flatnonzero(~wide)
    grid: defaultdict[tuple[int, int], list[int]] = defaultdict(list)
    for j, cells in zip(slim.tolist(), _cells(low_others[slim], high_others[slim], cell), strict=True):
        for key in cells:
            grid[key].append(j)
    counts: list[int] = []
    met: list[int] = []
    for cells in _cells(low, high, cell):
        found = dict.fromkeys([j for key in cells if key in grid for j in grid[key]])
        counts.append(len(found))
        met += found
    everywhere, every = np.flatnonzero(wide), np.arange(len(low))
    rows = np.concatenate([np.repeat(every, counts), np.repeat(every, len(everywhere))])
    cols = np.concatenate([np.array(met, np.intp), np.tile(everywhere, len(low))])
    order = np.lexsort((cols, rows))
    return rows[order], cols[order]


def _cells(low: Array, high: Array, cell: float) -> Iterator[list[tuple[int, int]]]:
    """Yield the cells of the grid that each footprint with corners (k, 2) or (k, 3) meets."""
    first, last = (np.floor(edge[:, :2] / cell).astype(np.int64).tolist() for edge in (low, high))
    for (x0, y0), (x1, y1) in zip(first, last, strict=True):
        yield [(x, y) for x in range(x0, x1 + 1) for y in range(y0, y1 + 1)]
