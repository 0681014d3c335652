"""The fixed objects of a cell file: tables, conveyors, stands."""

from ropsim.model import Box, FixedObject, Shape
from ropsim.spatial import Pose, frozen
from ropsim.workbench import cell_diagnostics as kinds
from ropsim.workbench.cell_objects import report_doubles
from ropsim.workbench.cell_poses import read_pose
from ropsim.workbench.cell_shapes import Look, read_look, read_shapes
from ropsim.workbench.quantity import Units
from ropsim.workbench.toml_checks import TomlTable

_SMALL_EDGE = 0.05  # [m], stands in while a wrong size is being reported


def read_objects(tables: tuple[TomlTable, ...], units: Units) -> tuple[FixedObject, ...]:
    """Return the objects in the order of the file."""
    objects = tuple(_object(table, units) for table in tables)
    if tables:
        spans = ((thing.name, table.value_span("name")) for table, thing in zip(tables, objects, strict=True))
        report_doubles(tables[0].findings, spans)
    return objects


def _object(table: TomlTable, units: Units) -> FixedObject:
    table.require("name", "position")
    name = table.text("name", "")
    X_WO = read_pose(table, units)
    look = read_look(table, Look())
    short = "size" in table
    if short and "shapes" in table:
        message = "`size` and `shapes` both say what the object looks like"
        table.findings.add(kinds.CONFLICTING_CELL_KEYS, table.key_span("shapes"), message, "keep one of them")
    if not short:
        table.require("shapes")
    shapes = _block(table, units, look) if short else read_shapes(table, units, look)
    table.finish()
    return FixedObject(name, X_WO, shapes)


def _block(table: TomlTable, units: Units, look: Look) -> tuple[Shape, ...]:
    """Return the box of the key `size`, below its position as parts are."""
    x, y, z = table.numbers("size", 3, units.extent, (_SMALL_EDGE,) * 3)
    return (look.shape(Box((x, y, z)), Pose(frozen([0.0, 0.0, -z / 2.0]))),)
