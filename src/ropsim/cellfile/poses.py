"""Poses in a cell file: `position` with `rpy`, `quaternion` or, for locations, `down`."""

import math
from collections.abc import Mapping

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.quantity import NUMBER, Units
from ropsim.cellfile.tomltext.checks import TomlTable
from ropsim.model import WORLD, Frame
from ropsim.spatial import Pose, quaternion

ORIGIN = (0.0, 0.0, 0.0)
TOOL_DOWN: quaternion.Quaternion = (0.0, 1.0, 0.0, 0.0)
"""Rx(π): the z axis of the tool points against the z axis of the frame, the x axes agree."""

_UNIT_LENGTH_TOLERANCE = 0.01  # lets three written decimals pass, refuses a missing or swapped number


def read_pose(table: TomlTable, units: Units) -> Pose:
    """Return the pose that `position` and `rpy` or `quaternion` give; each is optional."""
    return _pose(table, units, _orientation(table, units, quaternion.IDENTITY, ("rpy", "quaternion")))


def read_base(table: TomlTable, units: Units) -> Pose:
    """Return X_WB, the key `base` of a robot, a station or a device."""
    base = table.table("base")
    pose = read_pose(base, units)
    base.finish()
    return pose


def read_locations(
    tables: Mapping[str, TomlTable], frames: Mapping[str, Frame], units: Units
) -> tuple[dict[str, Pose], dict[str, str]]:
    """Return the named tool poses X_WT, and the names of the frames in which some are given.

    A location may be given in one of `frames`; the pose of one in a frame that moves is X_KT.
    """
    found = {name: _location(table, frames, units) for name, table in tables.items()}
    given = {name: frame for name, (_, frame) in found.items() if frame}
    return {name: pose for name, (pose, _) in found.items()}, given


def _location(table: TomlTable, frames: Mapping[str, Frame], units: Units) -> tuple[Pose, str]:
    table.require("position")
    frame = table.reference("frame", frames, "frame")
    down = TOOL_DOWN if table.flag("down", default=True) else quaternion.IDENTITY
    local = _pose(table, units, _orientation(table, units, down, ("rpy", "quaternion", "down")))
    table.finish()
    is_still = bool(frame) and frames[frame].parent == WORLD
    return (frames[frame].X_PK @ local if is_still else local), frame


def _pose(table: TomlTable, units: Units, orientation: quaternion.Quaternion) -> Pose:
    x, y, z = table.numbers("position", 3, units.position, ORIGIN)
    return Pose.from_tuple((x, y, z, *orientation))


def _orientation(
    table: TomlTable, units: Units, default: quaternion.Quaternion, keys: tuple[str, ...]
) -> quaternion.Quaternion:
    given = [key for key in keys if key in table]
    if len(given) > 1:
        message = f"{' and '.join(f'`{key}`' for key in given)} both give the orientation"
        table.findings.add(kinds.CONFLICTING_CELL_KEYS, table.key_span(given[1]), message, "keep one of them")
    if "rpy" in given:
        roll, pitch, yaw = table.numbers("rpy", 3, units.turn, ORIGIN)
        return quaternion.from_zyx(yaw, pitch, roll)
    if "quaternion" in given:
        w, x, y, z = table.numbers("quaternion", 4, NUMBER, quaternion.IDENTITY)
        length = math.sqrt(w * w + x * x + y * y + z * z)
        if abs(length - 1.0) > _UNIT_LENGTH_TOLERANCE:
            message = (
                f"`{table.name_of('quaternion')}` has the length {length:.4g}, a rotation has the length 1"
            )
            hint = "the order is w, x, y, z; `rpy` gives the same rotation by angles"
            table.findings.add(kinds.UNFIT_QUATERNION, table.value_span("quaternion"), message, hint)
            return default
        return quaternion.normalize((w, x, y, z))
    return default
