"""A body: a rigid entity that moves or stands still as one."""

from enum import StrEnum

from ropsim.model.drives.linkage import Linkage
from ropsim.model.geometry.elements import Shape
from ropsim.spatial import Pose, record

WORLD = ""
"""Parent of a body that is attached only to the world."""


class BodyKind(StrEnum):
    """Kind of a body in its cell."""

    BASE = "base"
    LINK = "link"
    TOOL = "tool"
    FINGER = "finger"
    CYLINDER = "cylinder"
    DEVICE = "device"
    OBJECT = "object"
    PART = "part"


@record
class Mover:
    """The joint that moves a body against its parent.

    Attributes:
        mechanism: name of the mechanism that the joint belongs to.
        joint: its number, from 0.
    """

    mechanism: str
    joint: int


class StrutEnd(StrEnum):
    """Which pin of a strut a body hangs on."""

    CARRIER = "carrier"
    LINK = "link"


@record
class Strut:
    """Mover of a body attached to one pin of a linkage and pointing along it: barrel or rod of a cylinder.

    Its z axis goes from the pin on the carrier to that on the link, its x axis is as near to the axis of the
    joint as that allows.

    Attributes:
        mechanism: name of the mechanism that the joint belongs to.
        joint: number of the joint that the linkage turns, from 0.
        linkage: the pins.
        end: the one that it hangs on.
    """

    mechanism: str
    joint: int
    linkage: Linkage
    end: StrutEnd


@record
class Body:
    """A rigid body where it hangs at time 0.

    Attributes:
        name: unique in the cell.
        kind: kind of body.
        parent: name of the body that it hangs on, `WORLD` for none.
        X_PB: its frame in that of the parent; of a moved body at joint coordinate 0.
        shapes: shapes in its own frame; without any, views draw a stand-in for arms.
        mover: source of its motion; None if it is fixed on its parent.
        visible: False for a tool that is not mounted and for a part that waits in its supply.
    """

    name: str
    kind: BodyKind
    parent: str
    X_PB: Pose
    shapes: tuple[Shape, ...] = ()
    mover: Mover | Strut | None = None
    visible: bool = True
