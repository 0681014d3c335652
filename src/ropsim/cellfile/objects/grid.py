"""Grids in a cell file: many parts, or many places, in rows, in rows and columns, or in layers of those."""

from collections.abc import Iterator
from itertools import product
from math import prod

import numpy as np

from ropsim.spatial import Array
from ropsim.tomltext import ORIGIN, WRONG_VALUE_COUNT, TomlTable, Units

MOST = 10000
"""Places of one grid."""

ORDERS = ("row", "column", "snake")
"""As in patterns of the task language: row by row, column by column, or rows in turn from either end."""


def read_grid(table: TomlTable, units: Units) -> list[Array]:
    """Return the shifts in world axes [m], shape (3,) each, layer by layer in the order of the table."""
    table.require("counts", "step")
    counts = [
        table.integer_at(("counts", k), one, 1, 100, 1) for k, one in enumerate(_items(table, "counts"))
    ]
    steps = [
        np.array(table.numbers_at(("step", k), one, 3, units.position, ORIGIN))
        for k, one in enumerate(_items(table, "step"))
    ]
    order = table.choice("order", ORDERS, ORDERS[0])
    table.finish()
    if not counts or len(counts) != len(steps):
        if counts and steps:
            table.wrong_count(("step",), steps, f"{len(counts)}, one for each of `counts`")
        return [np.zeros(3)]
    if prod(counts) > MOST:
        message = f"`{table.name_of('counts')}` makes {prod(counts)} places, {MOST} are allowed"
        table.findings.add(WRONG_VALUE_COUNT, table.value_span("counts"), message)
        return [np.zeros(3)]
    directions = np.zeros((3, 3))
    directions[: len(steps)] = steps
    columns, rows, layers = (*counts, 1, 1)[:3]
    return [np.array(at) @ directions for at in _walk(columns, rows, layers, order)]


def _walk(columns: int, rows: int, layers: int, order: str) -> Iterator[tuple[int, int, int]]:
    """Yield column, row and layer of each place, from 0."""
    if order == "column":
        yield from ((column, row, layer) for layer, column, row in _ranges(layers, columns, rows))
    elif order == "row":
        yield from ((column, row, layer) for layer, row, column in _ranges(layers, rows, columns))
    else:
        for layer, line, k in _ranges(layers, rows, columns):
            is_back = (layer * rows + line) % 2 == 1
            yield columns - 1 - k if is_back else k, rows - 1 - line if layer % 2 else line, layer


def _ranges(*counts: int) -> Iterator[tuple[int, ...]]:
    return product(*(range(count) for count in counts))


def _items(table: TomlTable, key: str) -> list[object]:
    """Return the one to three items of a list, or nothing."""
    value = table.values.get(key, []) if key in table else []
    if not isinstance(value, list):
        table.wrong_type((key,), value, "a list of one to three")
        return []
    if 1 <= len(value) <= 3 or key not in table:
        return value
    table.wrong_count((key,), value, "1 to 3")
    return []
