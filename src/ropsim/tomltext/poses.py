"""Poses in a TOML file: `position` with `rpy` or `quaternion`."""

import math

from ropsim.spatial import Pose, quaternion
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.doubts import note_metres, note_radians
from ropsim.tomltext.quantity import NUMBER, Units
from ropsim.tomltext.question import Question, Sort

ORIGIN = (0.0, 0.0, 0.0)

_UNIT_LENGTH_TOLERANCE = 0.01  # lets three written decimals pass, refuses a missing or swapped number


def read_pose(table: TomlTable, units: Units) -> Pose:
    """Return the pose of `position` and `rpy` or `quaternion`; each is optional.

    A position that seems to be in metres is noted.
    """
    note_metres(table, "position", units)
    return pose_of(table, units, read_orientation(table, units, quaternion.IDENTITY, ("rpy", "quaternion")))


def pose_of(table: TomlTable, units: Units, orientation: quaternion.Quaternion) -> Pose:
    """Return the pose of the key `position`, the origin where it is absent, with an orientation."""
    x, y, z = table.numbers("position", 3, units.position, ORIGIN)
    return Pose.from_tuple((x, y, z, *orientation))


def read_orientation(
    table: TomlTable, units: Units, default: quaternion.Quaternion, keys: tuple[str, ...]
) -> quaternion.Quaternion:
    """Return the rotation of one of `keys`, `default` if none is present.

    Args:
        table: with the keys.
        units: of the file.
        default: if none of them is present; also the value of a key that is neither a turn nor a quaternion.
        keys: for an orientation, of which one may be present.
    """
    given = [key for key in keys if key in table]
    if "rpy" in keys:
        table.ask("rpy", Question(Sort.NUMBERS, units.turn, count=3))
    if "quaternion" in keys:
        table.ask("quaternion", Question(Sort.NUMBERS, NUMBER, count=4))
    if len(given) > 1:
        message = f"{' and '.join(f'`{key}`' for key in given)} both give the orientation"
        table.findings.add(kinds.CONFLICTING_KEYS, table.key_span(given[1]), message, "keep one of them")
    if "rpy" in given:
        note_radians(table, "rpy", units)
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
