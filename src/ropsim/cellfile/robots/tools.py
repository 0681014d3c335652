"""The tools of a cell file."""

from collections.abc import Mapping

from ropsim import robots
from ropsim.model import Fingers, Gripper, Payload, Tool, ToolPart
from ropsim.spatial import Pose, frozen
from ropsim.tomltext import (
    DWELL,
    MASS,
    ORIGIN,
    VALUE_OUT_OF_RANGE,
    Look,
    TomlTable,
    Units,
    note_metres,
    read_inertia,
    read_look,
    read_pose,
    read_shapes,
)

_DWELL = 0.2  # [s], a pneumatic parallel gripper
_CAPTURE = 0.01  # [m]
_OPENED = 0.08  # [m], stands in while a wrong distance is being reported
_FINGER = (0.018, 0.006, 0.045)  # [m]


def read_tools(tables: Mapping[str, TomlTable], units: Units) -> dict[str, Tool]:
    """Return the tools by name, poses and centres of mass in the mechanical interface frame."""
    tools = {}
    for name, table in tables.items():
        pose = read_pose(table, units)
        mass = table.number("mass", MASS, 0.0)
        note_metres(table, "com", units)
        com = frozen(table.numbers("com", 3, units.position, ORIGIN))
        inertia = read_inertia(table, mass)
        gripper = _gripper(table.table("gripper"), pose, units) if "gripper" in table else None
        shapes = read_shapes(table, units, read_look(table, Look()))
        parts = tuple(_part(inner, units) for inner in table.tables("parts"))
        table.finish()
        tools[name] = Tool(name, pose, mass, com, inertia, gripper, shapes, parts)
    return tools


def _part(table: TomlTable, units: Units) -> ToolPart:
    """Return a rigid part of a tool; its pose is in the mechanical interface frame, all else in its own."""
    table.require("name")
    name, pose = table.text("name", ""), read_pose(table, units)
    mass = table.number("mass", MASS, 0.0)
    note_metres(table, "com", units)
    com = frozen(table.numbers("com", 3, units.position, ORIGIN))
    load = Payload(mass, com, read_inertia(table, mass))
    shapes = read_shapes(table, units, read_look(table, Look()))
    table.finish()
    return ToolPart(name, pose, load, shapes)


def _gripper(table: TomlTable, X_MT: Pose, units: Units) -> Gripper:
    fingers = _fingers(table.table("fingers"), X_MT, units) if "fingers" in table else None
    gripper = Gripper(
        table.number("open_time", DWELL, _DWELL),
        table.number("close_time", DWELL, _DWELL),
        table.number("capture", units.extent, _CAPTURE),
        fingers,
    )
    table.finish()
    return gripper


def _fingers(table: TomlTable, X_MT: Pose, units: Units) -> Fingers:
    table.require("open")
    opened = table.number("open", units.extent, _OPENED)
    closed = table.number("closed", units.position.within(0.0, 100.0), 0.0)
    if closed >= opened:
        message = f"`{table.name_of('closed')}` is not below `open`"
        hint = "both are distances between the fingers"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("closed"), message, hint)
        closed = 0.0
    size = table.numbers("size", 3, units.extent, _FINGER)
    table.finish()
    return robots.parallel_fingers(X_MT, opened, closed, (size[0], size[1], size[2]))
