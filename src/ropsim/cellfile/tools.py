"""The tools of a cell file."""

from collections.abc import Mapping

import numpy as np

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.poses import ORIGIN, read_pose
from ropsim.cellfile.quantity import DWELL, MASS, MOMENT, Units
from ropsim.cellfile.shapes import Look, read_look, read_shapes
from ropsim.cellfile.tomltext.checks import TomlTable
from ropsim.model import Gripper, Tool
from ropsim.spatial import Array, frozen

_DWELL = 0.2  # [s], a pneumatic parallel gripper
_CAPTURE = 0.01  # [m]
_ROUNDING = 1e-6  # relative; inertias are often written with few digits


def read_tools(tables: Mapping[str, TomlTable], units: Units) -> dict[str, Tool]:
    """Return the tools by name, poses and centres of mass in the mechanical interface frame."""
    tools = {}
    for name, table in tables.items():
        pose = read_pose(table, units)
        mass = table.number("mass", MASS, 0.0)
        com = frozen(table.numbers("com", 3, units.position, ORIGIN))
        inertia = _inertia(table, mass)
        gripper = _gripper(table.table("gripper"), units) if "gripper" in table else None
        shapes = read_shapes(table, units, read_look(table, Look()))
        table.finish()
        tools[name] = Tool(name, pose, mass, com, inertia, gripper, shapes)
    return tools


def _gripper(table: TomlTable, units: Units) -> Gripper:
    gripper = Gripper(
        table.number("open_time", DWELL, _DWELL),
        table.number("close_time", DWELL, _DWELL),
        table.number("capture", units.extent, _CAPTURE),
    )
    table.finish()
    return gripper


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
