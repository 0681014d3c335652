"""The places of parts in rows, in the order in which they are looked at."""

from collections.abc import Iterator
from itertools import chain, islice

from ropsim.core import frozen_dataclass
from ropsim.tasks.expression_text import short_text
from ropsim.tasks.task_call import Point

MOST_PLACES = 64
"""So many places of a pattern are looked at;
reach and collisions of one take about 10 ms when a machine is busy."""


@frozen_dataclass
class Spot:
    """One place of a pattern.

    Attributes:
        column: along X, from 1.
        row: along Y, from 1.
        point: where it is, as task text has it.
    """

    column: int
    row: int
    point: Point

    def __str__(self) -> str:
        words = self.point if isinstance(self.point, str) else f"({', '.join(map(short_text, self.point))})"
        return f"row {self.row}, column {self.column} at `{words}`"


def spots(first: Point, columns: int, rows: int, distance: float) -> tuple[Spot, ...]:
    """Return `MOST_PLACES` places of a pattern at most: its corners, what lies between them, then the inside.

    Args:
        first: place of column 1 in row 1, with whose orientation all others are.
        columns: places along X.
        rows: places along Y.
        distance: of each place from the next one [mm].
    """
    looked = islice(dict.fromkeys(islice(_numbers(columns, rows), 4 * MOST_PLACES)), MOST_PLACES)
    return tuple(Spot(c + 1, r + 1, _point(first, c * distance, r * distance)) for c, r in looked)


def _numbers(columns: int, rows: int) -> Iterator[tuple[int, int]]:
    last, end = columns - 1, rows - 1
    corners = ((0, 0), (last, 0), (0, end), (last, end))
    outline = chain(
        ((c, r) for c in range(columns) for r in (0, end)), ((c, r) for r in range(rows) for c in (0, last))
    )
    inside = ((c, r) for r in range(1, end) for c in range(1, last))
    return chain(corners, outline, inside)


def _point(first: Point, x: float, y: float) -> Point:
    if x == y == 0:
        return first
    if isinstance(first, str):
        return f"{first} offset ({short_text(x)}, {short_text(y)}, 0)"
    return first[0] + x, first[1] + y, *first[2:]
