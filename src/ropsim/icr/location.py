"""POSE values as locations: a pose, and what goes along wherever the location is passed and kept.

A POSE on the stack is a tuple of seven numbers, in the task frame in force when it is moved to. Behind them
stand values of external axes, where it has some, and the tag of a task frame of its own, where it has one.
"""

from typing import NamedTuple

from ropsim.icr.handlers import Datum
from ropsim.spatial import Pose, PoseTuple, quaternion

Location = tuple[Datum, ...]
"""(x, y, z, qw, qx, qy, qz) [m, 1], up to `MAX_EXTERNAL` values of external axes [rad | m], up to one tag."""


class FrameTag(NamedTuple):
    """The task frame of a location.

    Attributes:
        name: of the frame.
        X_BK: its nominal pose in the base frame.
    """

    name: str
    X_BK: Pose


def pose_part(location: Location) -> PoseTuple:
    """Return the pose of a location."""
    x, y, z, qw, qx, qy, qz = location[:7]
    return (x, y, z, qw, qx, qy, qz)


def external_part(location: Location) -> tuple[float, ...]:
    """Return the values of external axes that a location carries [rad | m]; empty where it has none."""
    return location[7:] if tag_of(location) is None else location[7:-1]


def tag_of(location: Location) -> FrameTag | None:
    """Return the task frame of its own of a location, None where it stands in the one in force."""
    last = location[-1]
    return last if isinstance(last, FrameTag) else None


def located(pose: PoseTuple, external: tuple[float, ...], tag: FrameTag | None) -> Location:
    """Return a location of its parts."""
    return (*pose, *external) if tag is None else (*pose, *external, tag)


def composed(left: Location, right: Location) -> Location:
    """Return X_AC of X_AB and X_BC.

    It carries the values of external axes of `left`, where that has none those of `right`, and so with the
    task frame: a location keeps its own whether it is moved in its tool frame (it is `left`) or brought into
    another frame (`right`).
    """
    if len(left) == len(right) == 7:
        return quaternion.compose(pose_part(left), pose_part(right))
    pose = quaternion.compose(pose_part(left), pose_part(right))
    external = external_part(left) or external_part(right)
    return located(pose, external, tag_of(left) or tag_of(right))


def in_frame(stack: list[Datum], _values: list[Datum], operand: Datum) -> None:
    """INFRAME; the operand is the tag, None for the task frame in force."""
    stack[-1] = located(pose_part(stack[-1]), external_part(stack[-1]), operand)
