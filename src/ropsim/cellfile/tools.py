"""The tools of a cell file."""

from collections.abc import Mapping

import numpy as np

from ropsim import robots
from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.poses import ORIGIN, read_pose
from ropsim.cellfile.quantity import DWELL, MASS, MOMENT, Units
from ropsim.cellfile.shapes import Look, read_look, read_shapes
from ropsim.cellfile.tomltext.checks import TomlTable
from ropsim.model import Fingers, Gripper, Payload, Tool, ToolPart
from ropsim.spatial import Array, Pose, frozen

_DWELL = 0.2  # [s], a pneumatic parallel gripper
_CAPTURE = 0.01  # [m]
_OPENED = 0.08  # [m], stands in while a wrong distance is being reported
_FINGER = (0.018, 0.006, 0.045)  # [m]
_ROUNDING = 1e-6  # relative; inertias are often written with few digits


def read_tools(tables: Mapping[str, TomlTable], units: Units) -> dict[str, Tool]:
    """Return the tools by name, poses and centres of mass in the mechanical interface frame."""
    tools = {}
    for name, table in tables.items():
        pose = read_pose(table, units)
        mass = table.number("mass", MASS, 0.0)
        com = frozen(table.numbers("com", 3, units.position, ORIGIN))
        inertia = _inertia(table, mass)
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
    com = frozen(table.numbers("com", 3, units.position, ORIGIN))
    load = Payload(mass, com, _inertia(table, mass))
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
        table.findings.add(kinds.VALUE_OUT_OF_RANGE, table.value_span("closed"), message, hint)
        closed = 0.0
    size = table.numbers("size", 3, units.extent, _FINGER)
    table.finish()
    return robots.parallel_fingers(X_MT, opened, closed, (size[0], size[1], size[2]))


def _inertia(table: TomlTable, mass: float) -> Array:
    """Return the tensor about the centre of mass [kg·m²], shape (3, 3)."""
    ixx, iyy, izz, ixy, ixz, iyz = table.numbers("inertia", 6, MOMENT, (0.0,) * 6)
    tensor = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    smallest, middle, greatest = np.linalg.eigvalsh(tensor).tolist()
    slack = _ROUNDING * max(abs(smallest), abs(greatest))
    message = ""
    if mass == 0.0 and greatest > 0.0:
        message = f"`{table.name_of('inertia')}` is not zero, but the mass is"
    elif smallest < -slack:
        message = f"`{table.name_of('inertia')}` has the negative principal moment {smallest:.6g} kg·m²"
    elif greatest > smallest + middle + slack:
        message = (
            f"`{table.name_of('inertia')}` has the principal moment {greatest:.6g} kg·m², "
            f"the other two allow at most {smallest + middle:.6g} kg·m²"
        )
    if message:
        hint = "the order is ixx, iyy, izz, ixy, ixz, iyz, in kg·m² about the centre of mass"
        table.findings.add(kinds.IMPOSSIBLE_INERTIA, table.value_span("inertia"), message, hint)
        return frozen(np.zeros((3, 3)))
    return frozen(tensor)
