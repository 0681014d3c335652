"""Tools at a mechanical interface: their parts, grippers and fingers."""

from dataclasses import field, replace
from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import COORDINATE, EXTENT, TIME, Ranges, check_ranges
from ropsim.model.geometry.elements import Shape
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.model.mechanism.number_check import check_body, check_finite
from ropsim.model.robots.payload import Payload, moved
from ropsim.spatial import Array, Pose, frozen, record


@record
class Fingers:
    """Fingers that move when a gripper opens and closes.

    Attributes:
        mechanism: of one axis, whose coordinate is half the distance between the fingers [m]; its base frame
            is the mechanical interface frame.
        opened: coordinate of the open gripper [m].
        closed: coordinate of the gripper that has closed on nothing [m].
    """

    RANGES: ClassVar[Ranges] = {"opened": COORDINATE, "closed": COORDINATE}

    mechanism: Mechanism
    opened: float
    closed: float


@frozen_dataclass
class Gripper:
    """The gripper of a tool.

    Attributes:
        open_time: dwell after the command to open [s].
        close_time: dwell after the command to close [s].
        capture: largest distance between the TCP and a part's grasp point when closing [m].
        fingers: None for a gripper that is drawn as standing still.
    """

    RANGES: ClassVar[Ranges] = {"open_time": TIME, "close_time": TIME, "capture": EXTENT}

    open_time: float
    close_time: float
    capture: float
    fingers: Fingers | None = None


@record
class ToolPart:
    """A rigid part of a tool, such as a flange adapter.

    Attributes:
        name: unique in its tool.
        X_MP: its frame in the mechanical interface frame.
        load: mass, centre of mass and inertia in its frame.
        shapes: shapes, in its frame.
    """

    RANGES: ClassVar[Ranges] = {"X_MP": COORDINATE}

    name: str
    X_MP: Pose
    load: Payload
    shapes: tuple[Shape, ...] = ()


@record
class Tool:
    """A tool at the mechanical interface.

    Attributes:
        name: as programs call it.
        X_MT: tool frame (origin = TCP) in the mechanical interface frame.
        mass: [kg], without that of its parts.
        com: centre of mass in the mechanical interface frame [m], shape (3,).
        inertia: about the centre of mass, in axes of the mechanical interface [kg·m²], shape (3, 3).
        gripper: None for a tool that cannot grasp.
        shapes: shapes, in the mechanical interface frame; where neither it nor its parts have any,
            `tool_shapes` makes a stand-in.
        parts: further parts of it.

    Raises:
        ModelValueError: the mass or inertia is negative, the inertia asymmetric, a number not finite,
            or one of the gripper outside its range.
    """

    name: str
    X_MT: Pose = field(default_factory=Pose)
    mass: float = 0.0
    com: Array = field(default_factory=lambda: frozen([0.0, 0.0, 0.0]))
    inertia: Array = field(default_factory=lambda: frozen([[0.0] * 3] * 3))
    gripper: Gripper | None = None
    shapes: tuple[Shape, ...] = ()
    parts: tuple[ToolPart, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "com", frozen(self.com))
        object.__setattr__(self, "inertia", frozen(self.inertia))
        check_body(f"tool `{self.name}`", self)
        check_finite(f"the pose of tool `{self.name}`", self.X_MT.as_tuple())
        check_ranges(
            f"tool `{self.name}`",
            {
                **{f"parts.{part.name}.": part for part in self.parts},
                **({"gripper.": self.gripper} if self.gripper else {}),
                **({"gripper.fingers.": self.fingers} if self.fingers else {}),
            },
        )

    @property
    def loads(self) -> tuple[Payload, ...]:
        """Return the rigid bodies that it is made of, in the mechanical interface frame."""
        own = Payload(self.mass, self.com, self.inertia)
        return (own, *(moved(part.load, part.X_MP) for part in self.parts))

    @property
    def look(self) -> tuple[Shape, ...]:
        """Return the shapes of the tool and of its parts, in the mechanical interface frame."""
        own = (replace(shape, pose=part.X_MP @ shape.pose) for part in self.parts for shape in part.shapes)
        return (*self.shapes, *own)

    @property
    def fingers(self) -> Fingers | None:
        """Return the fingers of its gripper, None where none of it moves."""
        return self.gripper.fingers if self.gripper else None
