"""The locations of a pattern in its order."""

from collections.abc import Iterator
from itertools import product as all_of

from support.programs import places
from support.programs.nodes import Pattern
from support.programs.places import FRAMES, Place


def cells(pattern: Pattern) -> Iterator[tuple[Place, dict[str, int]]]:
    """Yield the locations of a pattern in its order, with column, row and layer from 1."""
    columns, rows, layers = (*pattern.counts, 1, 1)[:3]
    frame = FRAMES[pattern.frame or "base"]
    for layer, (a, b) in all_of(range(layers), _order(pattern.order, columns, rows)):
        column, row = a, b
        if pattern.order == "snake":
            row = b if layer % 2 == 0 else rows - 1 - b
            column = a if (layer * rows + b) % 2 == 0 else columns - 1 - a
        x, y, z = (
            0.001 * c
            + sum(0.001 * n * step[k] for n, step in zip((column, row, layer), pattern.steps, strict=False))
            for k, c in enumerate(pattern.first)
        )
        place = places.read_in(Place(places.DOWN, (x, y, z)), frame)
        yield place, {"col": column + 1, "row": row + 1, "layer": layer + 1}


def _order(order: str, columns: int, rows: int) -> list[tuple[int, int]]:
    if order == "column":
        return [(a, b) for a in range(columns) for b in range(rows)]
    return [(a, b) for b in range(rows) for a in range(columns)]
