"""Poses in a cell file: `position` with `rpy`, `quaternion` or, for locations, `down`."""

from collections.abc import Mapping

from ropsim.flow import TargetOrientation
from ropsim.model import WORLD, Frame
from ropsim.spatial import Pose, quaternion
from ropsim.tomltext import TomlTable, Units, note_metres, pose_of, read_orientation, read_pose

TOOL_DOWN: quaternion.Quaternion = (0.0, 1.0, 0.0, 0.0)
"""Rx(π): the z axis of the tool points against the z axis of the frame, the x axes agree."""


def read_base(table: TomlTable, units: Units) -> Pose:
    """Return X_WB, the key `base` of a robot, a station or a device."""
    base = table.table("base")
    pose = read_pose(base, units)
    base.finish()
    return pose


def read_locations(
    tables: Mapping[str, TomlTable], frames: Mapping[str, Frame], units: Units
) -> tuple[dict[str, Pose], dict[str, str], frozenset[str]]:
    """Return the named tool poses X_WT, the frames in which some are given, and those with free orientation.

    A location may be given in one of `frames`; the pose of one in a frame that moves is X_KT.
    """
    free = frozenset(name for name, table in tables.items() if _is_free(table))
    found = {name: _location(table, frames, units) for name, table in tables.items()}
    given = {name: frame for name, (_, frame) in found.items() if frame}
    return {name: pose for name, (pose, _) in found.items()}, given, free


def _is_free(table: TomlTable) -> bool:
    given, free = (one.value for one in TargetOrientation)
    return table.choice("orientation", (given, free), given) == free


def _location(table: TomlTable, frames: Mapping[str, Frame], units: Units) -> tuple[Pose, str]:
    table.require("position")
    frame = table.reference("frame", frames, "frame")
    note_metres(table, "position", units)
    down = TOOL_DOWN if table.flag("down", default=True) else quaternion.IDENTITY
    local = pose_of(table, units, read_orientation(table, units, down, ("rpy", "quaternion", "down")))
    table.finish()
    is_still = bool(frame) and frames[frame].parent == WORLD
    return (frames[frame].X_PK @ local if is_still else local), frame
