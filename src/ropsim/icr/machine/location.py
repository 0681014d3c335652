"""POSE values as locations: a pose, and attributes that are passed and stored with it.

A POSE on the stack is a tuple of seven numbers, in the task frame in force when it is moved to. They are
followed by values of external axes, if any, the point of a list that it is made of, if any, the posture
request, if any, and the tag of its task frame, if any, else by the axes along which it is shifted, if they
differ from the axes of the task frame.
"""

import math
from dataclasses import replace
from typing import NamedTuple

from ropsim.flow import ListedPoint, PostureRequest, TargetOrientation
from ropsim.icr.machine.handlers import Datum
from ropsim.icr.machine.traps import out_of_range
from ropsim.spatial import Pose, PoseTuple, quaternion

Location = tuple[Datum, ...]
"""(x, y, z, qw, qx, qy, qz) [m, 1], up to `MAX_EXTERNAL` values of external axes [rad | m], then a point of a
list, a request and a tag, where it has them."""


class FrameTag(NamedTuple):
    """The task frame of a location.

    Attributes:
        name: of the frame.
        X_BK: its nominal pose in the base frame.
    """

    name: str
    X_BK: Pose


class Axes(NamedTuple):
    """The axes along which a location is shifted: a unit quaternion, seen in the task frame."""

    w: float
    x: float
    y: float
    z: float


_ATTRIBUTES = (FrameTag, PostureRequest, Axes, ListedPoint)
"""Types of what stands behind the numbers of a location."""


def pose_part(location: Location) -> PoseTuple:
    """Return the pose of a location."""
    x, y, z, qw, qx, qy, qz = location[:7]
    return (x, y, z, qw, qx, qy, qz)


def external_part(location: Location) -> tuple[float, ...]:
    """Return the values of external axes that a location carries [rad | m]; empty without any."""
    end = len(location)
    while isinstance(location[end - 1], _ATTRIBUTES):
        end -= 1
    return location[7:end]


def point_of(location: Location) -> ListedPoint | None:
    """Return the point of a list that a location is made of, None if it is made of none."""
    return next((part for part in location[7:] if isinstance(part, ListedPoint)), None)


def posture_of(location: Location) -> PostureRequest | None:
    """Return the posture request of a location, None if it leaves the posture open."""
    return next((part for part in location[-2:] if isinstance(part, PostureRequest)), None)


def axes_of(location: Location) -> Axes | None:
    """Return the axes along which a location is shifted, None if they equal those of its task frame."""
    last = location[-1]
    return last if isinstance(last, Axes) else None


def tag_of(location: Location) -> FrameTag | None:
    """Return the task frame of its own of a location, None where it stands in the one in force."""
    last = location[-1]
    return last if isinstance(last, FrameTag) else None


def located(
    pose: PoseTuple,
    external: tuple[float, ...],
    posture: PostureRequest | None,
    tag: FrameTag | None,
    axes: Axes | None,
    point: ListedPoint | None = None,
) -> Location:
    """Return a location of its parts; one in a frame of its own is shifted along that."""
    last = axes if tag is None else tag
    return (*pose, *external, *(part for part in (point, posture, last) if part is not None))


def composed(left: Location, right: Location) -> Location:
    """Return X_AC of X_AB and X_BC.

    It carries the values of external axes of `left`, else of `right`, and in the same way the posture, the
    axes and the task frame: a location keeps its own whether it is moved in its tool frame (it is `left`) or
    brought into another frame (`right`).
    """
    pose = quaternion.compose(pose_part(left), pose_part(right))
    if len(left) == len(right) == 7:
        return pose
    external = external_part(left) or external_part(right)
    posture, tag = posture_of(left) or posture_of(right), tag_of(left) or tag_of(right)
    point = point_of(left) or point_of(right)
    return located(pose, external, posture, tag, axes_of(left) or axes_of(right), point)


def in_frame(stack: list[Datum], _values: list[Datum], operand: Datum) -> None:
    """INFRAME; the operand is the tag, None for the task frame in force."""
    whole = stack[-1]
    stack[-1] = located(
        pose_part(whole), external_part(whole), posture_of(whole), operand, None, point_of(whole)
    )


def with_axes(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    """AXES: a location in a frame of its own keeps the axes of that."""
    axes = Axes(*stack.pop())
    stack[-1] = along(stack[-1], None if axes == quaternion.IDENTITY else axes)


def along(location: Location, axes: Axes | None) -> Location:
    """Return a location that is shifted along other axes."""
    own = posture_of(location), tag_of(location), axes, point_of(location)
    return located(pose_part(location), external_part(location), *own)


def offset(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    """OFFSET along the axes of the location."""
    way = stack.pop()
    location, axes = stack[-1], axes_of(stack[-1])
    x, y, z = way if axes is None else quaternion.rotate(axes, way)
    at = (location[0] + x, location[1] + y, location[2] + z)
    if not all(map(math.isfinite, at)):
        raise out_of_range("the result of `OFFSET` is not finite")
    stack[-1] = (*at, *location[3:])


def in_posture(stack: list[Datum], _values: list[Datum], operand: Datum) -> None:
    """POSTURE; the operand is the words of the posture with dashes between."""
    request = posture_of(stack[-1]) or PostureRequest()
    stack[-1] = _asking(stack[-1], replace(request, words=tuple(operand.split("-"))))


def with_turns(stack: list[Datum], _values: list[Datum], count: Datum) -> None:
    """TURNS; the operand is the number of axes."""
    turns = tuple(stack[-count:])
    del stack[-count:]
    request = posture_of(stack[-1]) or PostureRequest()
    stack[-1] = _asking(stack[-1], replace(request, turns=turns))


def orientation_free(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    """ORI.FREE; words of a posture and turns stay."""
    request = posture_of(stack[-1]) or PostureRequest()
    stack[-1] = _asking(stack[-1], replace(request, orientation=TargetOrientation.FREE))


def is_free(location: Location) -> bool:
    """Return whether the orientation of a location is free."""
    request = posture_of(location)
    return request is not None and request.orientation is TargetOrientation.FREE


def _asking(location: Location, request: PostureRequest) -> Location:
    own = tag_of(location), axes_of(location), point_of(location)
    return located(pose_part(location), external_part(location), request, *own)
