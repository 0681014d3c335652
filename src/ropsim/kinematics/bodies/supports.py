"""Supports: the body below a part, and bodies that it overlaps.

A part is tested along vertical lines through its footprint. The gap on a line is the height of its lower end
above the upper end of the body below. The floor is the plane z = 0 of the world.
"""

from collections import defaultdict
from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.kinematics.bodies.blocks import Blocks
from ropsim.kinematics.bodies.blocks_kernel import LINES, pair_gaps, stand_rows
from ropsim.model import WORLD
from ropsim.spatial import Array, frozen

FEW = 4
"""Fewer parts than this are compared with everything."""
MOST_CELLS = 256
"""A body that covers more cells of the grid than this is compared with every part."""


@frozen_dataclass
class Standing:
    """How a part stands.

    Attributes:
        on: name of the body that carries it, `WORLD` for the floor, None where nothing does.
        inside: name of the body in which it is the deepest, empty for none.
        depth: how much higher it would be free of the block of that body in which it is [m]; 0 for none.
    """

    on: str | None
    inside: str = ""
    depth: float = 0.0


def standings(parts: Blocks, others: Blocks, gap: float) -> list[Standing]:
    """Return how each part stands.

    Args:
        parts: one block for each part.
        others: possible supports; a part that is among them does not carry itself.
        gap: greatest height above a support that counts as standing on it [m].
    """
    pairs = (_every_pair if len(parts.owners) < FEW else _side_by_side)(parts, others)
    numbers = {name: float(number) for number, name in enumerate(parts.owners)}
    owners = np.array([numbers.get(name, -1.0) for name in others.owners])
    found, room = np.empty((len(parts.owners), 3)), np.empty((4, LINES * LINES))
    stand_rows(parts.boxes, others.boxes, owners, pairs, gap, room, found)
    return [
        _standing(others.owners, int(on), int(inside), depth, height, gap)
        for (on, inside, depth), height in zip(found.tolist(), parts.low[:, 2].tolist(), strict=True)
    ]


def height_above(parts: Blocks, row: int, others: Blocks) -> tuple[float, str]:
    """Return the height of a part above the nearest body below it [m], and its name: `WORLD` for the floor.

    The floor is meant below it only where nothing else is: the height is negative then.
    """
    count = len(others.owners)
    pairs, found = np.column_stack((np.full(count, float(row)), np.arange(count))), np.empty((count, 2))
    pair_gaps(parts.boxes, others.boxes, pairs, np.empty((4, LINES * LINES)), found)
    own = parts.owners[row]
    near = [
        (one, name)
        for one, name in zip(found[:, 0].tolist(), others.owners, strict=True)
        if name != own and np.isfinite(one)
    ]
    floor = float(parts.low[row, 2])
    if floor >= 0.0 or not near:
        near.append((floor, WORLD))
    return min(near, key=lambda one: (max(one[0], 0.0), one[1]))


def _standing(
    names: tuple[str, ...], on: int, inside: int, depth: float, height: float, gap: float
) -> Standing:
    """Return how a part stands, by the numbers of its support and an overlapped body, negative for none."""
    below = WORLD if abs(height) <= gap else None
    return Standing(names[on] if on >= 0 else below, names[inside] if inside >= 0 else "", depth)


def _every_pair(parts: Blocks, others: Blocks) -> Array:
    """Return all pairs (part, other), in order, shape (p, 2)."""
    return _pairs(len(parts.owners), len(others.owners))


@lru_cache(maxsize=16)
def _pairs(parts: int, others: int) -> Array:
    rows, cols = np.indices((parts, others)).reshape(2, -1)
    return frozen(np.column_stack((rows, cols)))


def _side_by_side(parts: Blocks, others: Blocks) -> Array:
    """Return the pairs (part, other) whose footprints may meet, in order, shape (p, 2).

    Footprints are entered into a grid whose cells are as large as half of the parts, so that a part is only
    compared with bodies in its cells.
    """
    low, high = parts.low, parts.high
    low_others, high_others = others.low, others.high
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
    return np.column_stack((rows[order], cols[order])).astype(np.float64)


def _cells(low: Array, high: Array, cell: float) -> Iterator[list[tuple[int, int]]]:
    """Yield the cells of the grid that each footprint with corners (k, 2) or (k, 3) meets."""
    first, last = (np.floor(edge[:, :2] / cell).astype(np.int64).tolist() for edge in (low, high))
    for (x0, y0), (x1, y1) in zip(first, last, strict=True):
        yield [(x, y) for x in range(x0, x1 + 1) for y in range(y0, y1 + 1)]
