"""Spans of a section that are slower than planned, in a loop that numba compiles."""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion import times_along
from ropsim.spatial import Array

START, STOP, SHARE, CELL = range(4)
"""Rows of spans."""
_TINY = 1e-300


class GridNumbers(NamedTuple):
    """Numbers of a limit grid of c cells.

    Attributes:
        borders: path parameters between which the cells lie, shape (c + 1,).
        times: of the motion there before the joints were regarded [s], shape (c + 1,).
        owners: number of the path segment of each cell, rising, shape (c,).
        begins: path parameters at which path segments begin, shape (p or more,).
        planned: bounds before the joints were regarded, shape (3, c).
        bounds: the same with regard to the joints, shape (3, c).
        causes: joint and quantity of each cell, below 0 where it has none, shape (2, c).
    """

    borders: Array1
    times: Array1
    owners: Array1
    begins: Array1
    planned: Array2
    bounds: Array2
    causes: Array2


@kernel
def slowed_spans(
    grid: GridNumbers, segments: Array2, ends: Array1, most: float, work: Array2, spans: Array2, total: Array1
) -> None:
    """Write spans on which bounds were lowered, and the cell with a cause that loses most speed in each.

    Args:
        grid: the limits.
        segments: of the time law, see `TimeLaw`, shape (8, m).
        ends: times at which its path segments end [s], shape (p,).
        most: greatest speed before the joints were regarded.
        work: of each border its path segment, path parameter there, time [s], and the cell before it, -1
            where a span begins, shape (4, 2·c).
        spans: results: begin and end [s], share of the greatest speed that is left in the slowest cell, and
            its number; shape (4, c).
        total: becomes the number of spans, shape (1,).
    """
    borders, times, owners, begins, planned, bounds, causes = grid
    last, count, goes_on = planned.shape[1] - 1, 0, False
    for cell in range(last + 1):
        lower = (
            (bounds[0, cell] < planned[0, cell])
            | (bounds[1, cell] < planned[1, cell])
            | (bounds[2, cell] < planned[2, cell])
        )
        if lower:
            if not goes_on:
                count = _add_border(borders, owners, begins, cell, -1, work, count)
            count = _add_border(borders, owners, begins, cell + 1, cell, work, count)
        goes_on = lower
    times_along(segments, ends, work[0, :count], work[1, :count], work[2, :count])
    span = 0
    for k in range(count):
        cell = int(work[3, k])
        if cell < 0:
            spans[START, span], spans[SHARE, span], spans[CELL, span] = work[2, k], 1.0, -1.0
            continue
        if causes[0, cell] >= 0.0:
            length = borders[cell + 1] - borders[cell]
            now = length / max(work[2, k] - work[2, k - 1], _TINY)
            then = length / max(times[cell + 1] - times[cell], _TINY)
            share = min(1.0 - (then - now) / most, 1.0)
            if spans[CELL, span] < 0.0 or share < spans[SHARE, span]:
                spans[SHARE, span], spans[CELL, span] = share, cell
        if k + 1 == count or work[3, k + 1] < 0.0:
            spans[STOP, span] = work[2, k]
            if spans[CELL, span] >= 0.0:
                span += 1
    total[0] = span


def _add_border(
    borders: Array, owners: Array, begins: Array, border: int, cell: int, work: Array, count: int
) -> int:
    """Write a border and the cell that ends there, or -1; return the number of all."""
    segment = owners[min(border, owners.shape[0] - 1)]
    work[0, count], work[1, count], work[3, count] = segment, borders[border] - begins[int(segment)], cell
    return count + 1
