"""The work cell: one robot with its tools, frames, parts and signals."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from ropsim.model.controller import ControllerModel
from ropsim.model.geometry import Material, Shape
from ropsim.model.robot import RobotModel
from ropsim.spatial import Array, Pose, frozen, record

PART_COLOUR = "#d99a3d"
"""Colour of parts that have been given none."""


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


@record
class Destination:
    """Where a part is to be when a run ends.

    Attributes:
        X_WO: pose of its object frame in the world frame.
        distance: greatest distance from there [m].
        turn: greatest angle between the orientations [rad]; None where only the place counts.
    """

    X_WO: Pose
    distance: float
    turn: float | None


@record
class Part:
    """A box-shaped object that can be grasped.

    Attributes:
        name: unique.
        size: edges along its own x, y, z [m], shape (3,).
        mass: [kg].
        X_WO: pose of the object frame (grasp point, top centre, z up) in the world frame at time 0; for a
            part of a supply, the pose at the supply.
        supply: name of the supply it comes from, empty for a part that lies there from the start.
        turn: place in the queue of its supply: it appears when the part before it has been taken away.
        colour: `#rrggbb`.
        material: how its surface takes the light.
        destination: where it is to be at the end, None where that is free.
    """

    name: str
    size: Array
    mass: float
    X_WO: Pose
    supply: str = ""
    turn: int = 0
    colour: str = PART_COLOUR
    material: Material = Material.PAINT
    destination: Destination | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", frozen(self.size))


@dataclass(frozen=True, slots=True)
class FixedObject:
    """A thing of the cell that never moves; parts can lie on it.

    Attributes:
        name: unique among the bodies of the cell.
        X_PO: its frame in that of its parent; in the world frame without one.
        shapes: what it looks like, in its frame.
        parent: name of the object that it hangs on, empty for none.
    """

    name: str
    X_PO: Pose
    shapes: tuple[Shape, ...]
    parent: str = ""


@dataclass(frozen=True, slots=True)
class Sink:
    """A place where released parts leave the cell.

    Attributes:
        name: unique.
        position: centre in the world frame [m].
        radius: [m].
    """

    name: str
    position: tuple[float, float, float]
    radius: float


@dataclass(frozen=True, slots=True)
class SupportLimits:
    """When a part lies on something, and when it is in it.

    Attributes:
        gap: greatest height of a part above its support [m].
        depth: greatest depth of a released part in something else [m].
    """

    gap: float = 0.005
    depth: float = 0.002


@dataclass(frozen=True, slots=True)
class Signal:
    """A digital or analog channel of the cell.

    Attributes:
        name: as programs call it.
        is_input: input to the controller, else output.
        analog: real-valued, else on/off.
        initial: value at time 0.
        changes: later values of an input as (time [s], value), in order of time.
        channel: number at the controller's terminals, 0 where it is not known.
    """

    name: str
    is_input: bool
    analog: bool = False
    initial: float = 0.0
    changes: tuple[tuple[float, float], ...] = ()
    channel: int = 0


@dataclass(frozen=True, slots=True)
class ClassicSettings:
    """How classic task files are read: units of bare numbers and the frame of their points.

    Attributes:
        length: metres per unit of a bare length.
        angle: radians per unit of a bare angle.
        frame: name of the frame, empty for the base frame.
    """

    length: float = 0.01
    angle: float = 0.017453292519943295
    frame: str = ""


@record
class Cell:
    """One robot and everything that its programs can name; all poses are in the world frame W.

    Programs and the controller work in the base frame B of the robot: `in_base` is the way there.

    Attributes:
        name: of the project.
        robot: the arm.
        X_WB: base frame in the world frame.
        controller: its controller.
        tools: by name.
        default_tool: tool at program start, empty for none.
        frames: task frames X_WK by name.
        locations: named points (tool poses X_WT) by name.
        parts: what can be grasped.
        objects: what stands around.
        sinks: where parts leave.
        supports: when a part lies on something.
        signals: by name.
        classic: settings for classic files.
        start: joint coordinates at time 0 [rad | m], shape (n,).
        program: name of the program that runs when the user names none.
    """

    name: str
    robot: RobotModel
    controller: ControllerModel
    X_WB: Pose = field(default_factory=Pose)
    tools: Mapping[str, Tool] = field(default_factory=dict)
    default_tool: str = ""
    frames: Mapping[str, Pose] = field(default_factory=dict)
    locations: Mapping[str, Pose] = field(default_factory=dict)
    parts: tuple[Part, ...] = ()
    objects: tuple[FixedObject, ...] = ()
    sinks: tuple[Sink, ...] = ()
    supports: SupportLimits = SupportLimits()
    signals: Mapping[str, Signal] = field(default_factory=dict)
    classic: ClassicSettings = field(default_factory=ClassicSettings)
    start: Array = field(default_factory=lambda: frozen([]))
    program: str = "main"

    def __post_init__(self) -> None:
        object.__setattr__(self, "start", frozen(self.start))
