"""The key `units` of a TOML file."""

from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.quantity import ANGLE_UNITS, LENGTH_UNITS, Units


def read_units(table: TomlTable) -> Units:
    """Return the units of lengths and angles; millimetres and degrees where nothing is said."""
    units = Units(table.choice("length", LENGTH_UNITS, "mm"), table.choice("angle", ANGLE_UNITS, "deg"))
    table.finish()
    return units
