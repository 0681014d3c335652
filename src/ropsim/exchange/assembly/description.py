"""A robot as its file describes it: bodies by name and connections; every format is read to this."""

from collections.abc import Mapping
from dataclasses import field
from enum import Enum
from types import MappingProxyType

from ropsim.core import Span, frozen_dataclass
from ropsim.model import Payload, Shape
from ropsim.spatial import Pose


class Motion(Enum):
    """Motion that a connection allows its child."""

    TURN = "turn"
    SLIDE = "slide"
    NONE = "none"


@frozen_dataclass
class Body:
    """A rigid body.

    Attributes:
        name: of the link.
        weight: mass, centre of mass and inertia about that, in the frame of the body.
        shapes: geometry, in the frame of the body.
        span: where it stands.
        is_collision: whether the link has collision geometry in the file, and no visual geometry.
    """

    name: str
    weight: Payload
    shapes: tuple[Shape, ...]
    span: Span
    is_collision: bool = False


@frozen_dataclass
class Limits:
    """Limits of a connection; None if missing in the file.

    Attributes:
        lower: of the coordinate [rad | m].
        upper: [rad | m].
        speed: [rad/s | m/s].
        acceleration: [rad/s² | m/s²].
        jerk: [rad/s³ | m/s³].
        effort: [N·m | N].
    """

    lower: float
    upper: float
    speed: float | None = None
    acceleration: float | None = None
    jerk: float | None = None
    effort: float | None = None


@frozen_dataclass
class Resistance:
    """Resistance of a joint to its motion.

    Attributes:
        viscous: [N·m·s/rad | N·s/m].
        dry: [N·m | N].
        rotor: inertia that moves with the joint alone [kg·m² | kg].
    """

    viscous: float = 0.0
    dry: float = 0.0
    rotor: float = 0.0


@frozen_dataclass
class Following:
    """The coordinate of a connection as a linear function of others: Σ factor · q_other + constant.

    Attributes:
        terms: names of connections with their factors.
        constant: [rad | m].
    """

    terms: tuple[tuple[str, float], ...]
    constant: float = 0.0


@frozen_dataclass
class Connection:
    """A joint of the file.

    Attributes:
        name: of the joint.
        motion: motion that it allows its child.
        parent: name of the body that carries it.
        child: name of the body that it moves.
        X_PC: frame of the child in that of its parent where the joint has not moved it.
        axis: unit vector in the frame of the child.
        zero: coordinate at which the joint has not moved its child [rad | m].
        limits: of the coordinate.
        resistance: friction and rotor.
        following: coupling that determines the coordinate, if it is not driven.
        span: where it stands.
    """

    name: str
    motion: Motion
    parent: str
    child: str
    X_PC: Pose
    span: Span
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    zero: float = 0.0
    limits: Limits = Limits(0.0, 0.0)
    resistance: Resistance = Resistance()
    following: Following | None = None


@frozen_dataclass
class Description:
    """Everything that a robot file describes.

    Attributes:
        name: of the robot.
        bodies: in the order of the file.
        connections: in the order of the file.
        gravity: acceleration of free fall [m/s²]; None where the file does not say.
        home: coordinates of connections in the rest position, by name [rad | m].
        span: of the outermost element.
        axes: names of the connections that are driven, in the order of the axes; none for that of the file.
        frames: named frames that are fixed to bodies: the body, and the frame in that of it.
    """

    name: str
    bodies: tuple[Body, ...]
    connections: tuple[Connection, ...]
    span: Span
    gravity: tuple[float, float, float] | None = None
    home: tuple[tuple[str, float], ...] = ()
    axes: tuple[str, ...] = ()
    frames: Mapping[str, tuple[str, Pose]] = field(default_factory=lambda: _NO_FRAMES)


_NO_FRAMES: Mapping[str, tuple[str, Pose]] = MappingProxyType({})
