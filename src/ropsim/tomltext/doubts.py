"""Numbers that are most often meant in another unit."""

from math import pi

from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.quantity import Units
from ropsim.tomltext.words import float_of

_RIGHT = 1e-4
"""Difference at which the digits of a right angle in radians are recognised."""
_NEAR = 2.0
"""A position of no more than this, and no whole number, is most often one in metres [mm]."""
_METRES = 'are these metres? Then write millimetres, or `length = "m"` under `[units]`'


def note_radians(table: TomlTable, key: str, units: Units) -> None:
    """Note an angle, or one of several, that has the digits of a quarter or half a turn in radians (X822)."""
    if units.angle != "deg":
        return
    for value in _numbers(table, key):
        for turn, degrees in ((pi / 2.0, 90), (pi, 180)):
            if abs(abs(value) - turn) < _RIGHT:
                message = f"`{table.name_of(key)}` is {value:g}°, the digits of {degrees}° in radians"
                hint = f'write {degrees if value > 0 else -degrees}, or say that angles are in `"rad"`'
                table.findings.add(kinds.LOOKS_LIKE_RADIANS, table.value_span(key), message, hint)
                return


def note_metres(table: TomlTable, key: str, units: Units) -> None:
    """Note a position that is nearly at its origin, as one in metres is (X823)."""
    values = _numbers(table, key)
    if units.length != "mm" or not values:
        return
    if 0.0 < max(map(abs, values)) < _NEAR and any(value % 1.0 for value in values):
        shown = ", ".join(f"{value:g}" for value in values)
        message = f"`{table.name_of(key)}` is ({shown}) mm"
        table.findings.add(kinds.LOOKS_LIKE_METRES, table.value_span(key), message, _METRES)


def _numbers(table: TomlTable, key: str) -> list[float]:
    """Return the finite numbers of a key, none where something else stands there."""
    value = table.values.get(key)
    items = value if isinstance(value, list) else [value]
    numbers = [float_of(one) for one in items if isinstance(one, int | float) and not isinstance(one, bool)]
    return numbers if len(numbers) == len(items) else []
