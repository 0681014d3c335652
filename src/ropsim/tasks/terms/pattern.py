"""The places of parts in rows, in the order in which they are checked."""

from collections.abc import Iterator
from itertools import chain, islice

from ropsim.core import frozen_dataclass
from ropsim.tasks.terms.expression_text import short_text
from ropsim.tasks.terms.point import Point, point_text

MOST_PLACES = 64
"""Number of places of a pattern that are checked; one takes about 10 ms on a busy machine."""

MOST_IN_ROWS = 1000
"""Number of places of a pattern whose contents are known."""


@frozen_dataclass
class Spot:
    """One place of a pattern.

    Attributes:
        column: along X of the first place, from 1.
        row: against its Y, from 1: to the left of X for who looks along the approach of the tool.
        point: where it is, as task text has it.
    """

    column: int
    row: int
    point: Point

    def __str__(self) -> str:
        return f"row {self.row}, column {self.column} at `{point_text(self.point)}`"


def spots(first: Point, columns: int, rows: int, distance: float) -> tuple[Spot, ...]:
    """Return `MOST_PLACES` places of a pattern at most: its corners, points between them, then the inside.

    Args:
        first: place of column 1 in row 1, with whose orientation all others are.
        columns: places along X of the first one.
        rows: places against its Y.
        distance: of each place from the next one [mm].
    """
    looked = islice(dict.fromkeys(islice(_numbers(columns, rows), 4 * MOST_PLACES)), MOST_PLACES)
    return tuple(Spot(c + 1, r + 1, _point(first, c * distance, r * distance)) for c, r in looked)


def neighbours(columns: int, rows: int) -> tuple[tuple[int, int], ...]:
    """Return how many columns and rows a place of a pattern is from those next to it, one per line."""
    steps = ((1, 0), (0, 1), (1, 1), (-1, 1))
    return tuple((c, r) for c, r in steps if abs(c) < columns and r < rows)


def _numbers(columns: int, rows: int) -> Iterator[tuple[int, int]]:
    last, end = columns - 1, rows - 1
    corners = ((0, 0), (last, 0), (0, end), (last, end))
    outline = chain(
        ((c, r) for c in range(columns) for r in (0, end)), ((c, r) for r in range(rows) for c in (0, last))
    )
    inside = ((c, r) for r in range(1, end) for c in range(1, last))
    return chain(corners, outline, inside)


def places_in_rows(first: Point, columns: int, rows: int, distance: float) -> tuple[Point, ...]:
    """Return the places of a pattern in the order in which a program fills them, `MOST_IN_ROWS` at most.

    Args:
        first: as with `spots`.
        columns: number of columns.
        rows: number of rows.
        distance: spacing [mm].
    """
    count = min(max(columns, 0) * max(rows, 0), MOST_IN_ROWS)
    numbers = (divmod(place, columns) for place in range(count))  # empty rows without number end at once
    return tuple(_point(first, column * distance, row * distance) for row, column in numbers)


def _point(first: Point, x: float, y: float) -> Point:
    """Return a place that is moved by x along X of another one and by y against its Y [mm]."""
    if x == y == 0:
        return first
    if isinstance(first, tuple) and len(first) == 3:  # the tool points down, its X along that of the base
        return first[0] + x, first[1] + y, first[2]
    return f"{point_text(first)} rel ({short_text(x)}, {short_text(0.0 - y)}, 0)"
