"""Shapes of the moving body of a device or of a station of one axis: `size`, `diameter` or `shapes`."""

from ropsim.model import Box, Cylinder, Shape
from ropsim.spatial import Pose, frozen
from ropsim.tomltext import CONFLICTING_KEYS, Look, TomlTable, Units, read_look, read_shapes

BODY_KEYS = ("size", "diameter", "shapes")
"""Keys that give the shapes of the body; one of them is needed."""
_SMALL = 0.05  # [m], stands in while a wrong size is being reported


def read_body_shapes(table: TomlTable, units: Units) -> tuple[Shape, ...]:
    """Return the shapes of the moving body: `shapes`, or a block or disc whose top is at its frame."""
    look = read_look(table, Look())
    given = [key for key in BODY_KEYS if key in table]
    if len(given) > 1:
        message = f"`{given[0]}` and `{given[1]}` both say what the device looks like"
        table.findings.add(CONFLICTING_KEYS, table.key_span(given[1]), message, "keep one of them")
    if not given:
        table.require("size")
        return ()
    if given[0] == "shapes":
        return read_shapes(table, units, look)
    if given[0] == "size":
        x, y, z = table.numbers("size", 3, units.extent, (_SMALL,) * 3)
        return (look.shape(Box((x, y, z)), Pose(frozen([0.0, 0.0, -z / 2.0]))),)
    diameter = table.number("diameter", units.extent, _SMALL)
    height = table.number("height", units.extent, 0.05)
    return (look.shape(Cylinder(diameter / 2.0, height), Pose(frozen([0.0, 0.0, -height / 2.0]))),)
