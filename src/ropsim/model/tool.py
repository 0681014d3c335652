"""Tools at a mechanical interface, and their grippers."""

from dataclasses import dataclass, field

from ropsim.model.geometry import Shape
from ropsim.spatial import Array, Pose, frozen, record


@dataclass(frozen=True, slots=True)
class Gripper:
    """The gripper of a tool.

    Attributes:
        open_time: dwell after the command to open [s].
        close_time: dwell after the command to close [s].
        capture: largest distance between the TCP and a part's grasp point when closing [m].
    """

    open_time: float
    close_time: float
    capture: float


@record
class Tool:
    """A tool at the mechanical interface.

    Attributes:
        name: as programs call it.
        X_MT: tool frame (origin = TCP) in the mechanical interface frame.
        mass: [kg].
        com: centre of mass in the mechanical interface frame [m], shape (3,).
        inertia: about the centre of mass, in axes of the mechanical interface [kg·m²], shape (3, 3).
        gripper: None for a tool that cannot grasp.
        shapes: what it looks like, in the mechanical interface frame; without any, views draw a stand-in.
    """

    name: str
    X_MT: Pose = field(default_factory=Pose)
    mass: float = 0.0
    com: Array = field(default_factory=lambda: frozen([0.0, 0.0, 0.0]))
    inertia: Array = field(default_factory=lambda: frozen([[0.0] * 3] * 3))
    gripper: Gripper | None = None
    shapes: tuple[Shape, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "com", frozen(self.com))
        object.__setattr__(self, "inertia", frozen(self.inertia))
