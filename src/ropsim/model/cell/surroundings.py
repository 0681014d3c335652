"""Surroundings in a cell: fixed objects, sinks, and tolerances for support."""

from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import COORDINATE, EXTENT, Ranges
from ropsim.model.geometry.elements import Shape
from ropsim.spatial import Pose


@frozen_dataclass
class FixedObject:
    """A thing of the cell that moves with its parent only; parts can lie on it.

    Attributes:
        name: unique among the bodies of the cell.
        X_PO: its frame in that of its parent; in the world frame without one.
        shapes: shapes, in its frame.
        parent: name of the object, or of the body of a device, that it hangs on; empty for none.
    """

    RANGES: ClassVar[Ranges] = {"X_PO": COORDINATE}

    name: str
    X_PO: Pose
    shapes: tuple[Shape, ...]
    parent: str = ""


@frozen_dataclass
class Sink:
    """A place where released parts leave the cell.

    Attributes:
        name: unique.
        position: centre in the world frame [m].
        radius: [m].
    """

    RANGES: ClassVar[Ranges] = {"position": COORDINATE, "radius": EXTENT}

    name: str
    position: tuple[float, float, float]
    radius: float


@frozen_dataclass
class SupportLimits:
    """When a part lies on something, and when it is in it.

    Attributes:
        gap: greatest height of a part above its support [m].
        depth: greatest depth of a released part in something else [m].
    """

    RANGES: ClassVar[Ranges] = {"gap": EXTENT, "depth": EXTENT}

    gap: float = 0.005
    depth: float = 0.002
