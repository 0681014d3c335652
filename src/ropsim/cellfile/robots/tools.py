"""The tools of a cell file."""

from collections.abc import Mapping

from ropsim import parts
from ropsim.cellfile.library_parts import GivenPart, placed, read_painted, read_part, reweighed
from ropsim.model import Fingers, Gripper, Payload, Shape, Tool, ToolPart
from ropsim.parts import Use
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

_GRIPPER = Gripper(0.2, 0.2, 0.01)
"""A pneumatic parallel gripper that is drawn as standing still."""
_OPENED = 0.08  # [m], stands in while a wrong distance is being reported
_FINGER = (0.018, 0.006, 0.045)  # [m]


def read_tools(tables: Mapping[str, TomlTable], units: Units) -> dict[str, Tool]:
    """Return the tools by name, poses and centres of mass in the mechanical interface frame."""
    tools = {}
    for name, table in tables.items():
        given = read_part(table, units, Use.TOOL)
        pose = placed(table, read_pose(table, units), given.part.X_MT if given else None)
        load = _load(table, units, given)
        gripper = given.part.gripper if given else None
        if "gripper" in table:
            gripper = _gripper(table.table("gripper"), pose, units, gripper or _GRIPPER)
        shapes = _shapes(table, units, given)
        rigid = tuple(_part(inner, units) for inner in table.tables("parts"))
        table.finish()
        tools[name] = Tool(name, pose, load.mass, load.com, load.inertia, gripper, shapes, rigid)
    return tools


def _part(table: TomlTable, units: Units) -> ToolPart:
    """Return a rigid part of a tool; its pose is in the mechanical interface frame, all else in its own."""
    table.require("name")
    name, pose = table.text("name", ""), read_pose(table, units)
    given = read_part(table, units, Use.TOOL)
    load, shapes = _load(table, units, given), _shapes(table, units, given)
    table.finish()
    return ToolPart(name, pose, load, shapes)


def _load(table: TomlTable, units: Units, given: GivenPart | None) -> Payload:
    """Return mass, centre of mass and inertia: of the keys, else of the library part."""
    own = given.part.load if given else Payload()
    mass = table.number("mass", MASS, own.mass)
    note_metres(table, "com", units)
    com = frozen(table.numbers("com", 3, units.position, ORIGIN)) if "com" in table or not given else own.com
    inertia = read_inertia(table, mass)
    return Payload(mass, com, inertia if "inertia" in table else reweighed(own, mass).inertia)


def _shapes(table: TomlTable, units: Units, given: GivenPart | None) -> tuple[Shape, ...]:
    """Return the shapes of the keys, else of the library part."""
    if given is not None:
        return read_painted(table, units, given.part)
    return read_shapes(table, units, read_look(table, Look()))


def _gripper(table: TomlTable, X_MT: Pose, units: Units, own: Gripper) -> Gripper:
    """Return the gripper of the keys, completed by another one."""
    fingers = _fingers(table.table("fingers"), X_MT, units) if "fingers" in table else own.fingers
    gripper = Gripper(
        table.number("open_time", DWELL, own.open_time),
        table.number("close_time", DWELL, own.close_time),
        table.number("capture", units.extent, own.capture),
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
    return parts.parallel_fingers(X_MT, opened, closed, (size[0], size[1], size[2]))
