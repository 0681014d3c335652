"""A list of points for programs: the poses of its points."""

from math import atan2, radians

from ropsim.language import PointTable
from ropsim.spatial import PoseTuple, approach_orientation, quaternion
from ropsim.tasks.terms.point import Coordinates, typed_numbers
from ropsim.tasks.world.point_list import PointList

_DOWN = (0.0, 1.0, 0.0, 0.0)
"""Rx(180°): the tool points straight down in its frame, as for three plain numbers in a program."""


def point_table(listed: PointList, source: str = "") -> PointTable | None:
    """Return a list as programs use it, None for an empty one.

    Poses are those of the same numbers in a program: X Y Z, X Y Z Pitch Roll or X Y Z with pitch, roll and
    yaw of the approach direction. The azimuth of a point with a pitch and no yaw counts in the frame of the
    list.
    """
    if not listed.points:
        return None
    poses = tuple([_pose(point) for _, point in listed.points])
    return PointTable(poses, listed.numbers, source, listed.lines)


def _pose(point: Coordinates) -> PoseTuple:
    numbers = typed_numbers(point)
    x, y, z = (one / 1000.0 for one in numbers[:3])
    if len(numbers) == 3:
        return (x, y, z, *_DOWN)
    pitch, roll = radians(numbers[3]), radians(numbers[4])
    yaw = radians(numbers[5]) if len(numbers) == 6 else atan2(y, x)
    return (x, y, z, *quaternion.unit(approach_orientation(pitch, roll, yaw)))
