"""Grids in a cell file: many parts, or many places, by two counts and two steps."""

import numpy as np

from ropsim.spatial import Array
from ropsim.tomltext import ORIGIN, TomlTable, Units


def read_grid(table: TomlTable, units: Units) -> list[Array]:
    """Return the shifts in world axes [m], shape (3,) each; the first direction runs fastest."""
    table.require("counts", "step")
    counts = _items(table, "counts")
    nx, ny = (table.integer_at(("counts", k), counts[k], 1, 100, 1) for k in range(2)) if counts else (1, 1)
    steps = _items(table, "step")
    directions = [
        np.array(table.numbers_at(("step", k), step, 3, units.position, ORIGIN))
        for k, step in enumerate(steps)
    ]
    table.finish()
    if len(directions) != 2:
        return [np.zeros(3)]
    return [i * directions[0] + j * directions[1] for j in range(ny) for i in range(nx)]


def _items(table: TomlTable, key: str) -> list[object]:
    """Return the two items of a list, or nothing."""
    value = table.values.get(key, []) if key in table else []
    if not isinstance(value, list):
        table.wrong_type((key,), value, "a list of two")
        return []
    if len(value) == 2 or key not in table:
        return value
    table.wrong_count((key,), value, "2")
    return []
