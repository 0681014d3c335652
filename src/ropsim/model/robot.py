"""The neutral model of a serial arm: joints, links, drives and where each number comes from."""

from dataclasses import dataclass, field
from enum import Enum

from ropsim.model.drive import Drive
from ropsim.model.geometry import Shape
from ropsim.spatial import Array, Pose, frozen, record


class JointType(Enum):
    """The pair that a joint forms."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"


@record
class Joint:
    """A driven joint; it turns about or slides along the z axis of its own frame.

    Attributes:
        name: such as `1`.
        type: revolute or prismatic.
        placement: fixed pose of the joint frame at coordinate 0 in the frame of the joint before it
            (in the base frame for joint 1).
        offset: added to the coordinate before it moves the joint [rad | m] (theta or d of the DH row).
        lower: lower limit of the coordinate [rad | m].
        upper: upper limit [rad | m].
        max_speed: [rad/s | m/s].
        max_acceleration: [rad/s² | m/s²].
        max_jerk: [rad/s³ | m/s³].
        max_effort: largest torque or force at the joint [N·m | N]; inf where unknown.
    """

    name: str
    type: JointType
    placement: Pose
    offset: float
    lower: float
    upper: float
    max_speed: float
    max_acceleration: float
    max_jerk: float
    max_effort: float = float("inf")


@record
class Link:
    """The rigid body that a joint moves; all quantities in the frame of that joint.

    Attributes:
        mass: [kg].
        com: centre of mass [m], shape (3,).
        inertia: inertia tensor about the centre of mass [kg·m²], shape (3, 3).
        shapes: what it looks like; without any, views draw a stand-in.
    """

    mass: float
    com: Array
    inertia: Array
    shapes: tuple[Shape, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "com", frozen(self.com))
        object.__setattr__(self, "inertia", frozen(self.inertia))


@dataclass(frozen=True, slots=True)
class ParameterOrigin:
    """Where a group of parameters comes from.

    Attributes:
        parameters: what it covers, such as `motor constants`.
        kind: `published`, `derived` or `estimated`.
        source: paper, table or reasoning.
    """

    parameters: str
    kind: str
    source: str


@dataclass(frozen=True, slots=True)
class DhRow:
    """One row of a Denavit–Hartenberg table in the standard form Rz(θ)·Tz(d)·Tx(a)·Rx(α).

    Attributes:
        a: [m].
        alpha: [rad].
        d: [m]; offset of the coordinate for a prismatic joint.
        theta: [rad]; offset of the coordinate for a revolute joint.
        type: which of θ and d is the joint coordinate.
    """

    a: float
    alpha: float
    d: float
    theta: float = 0.0
    type: JointType = JointType.REVOLUTE


@record
class RobotModel:
    """A serial arm; immutable, shared by all runs.

    Attributes:
        name: short name.
        title: maker and model.
        joints: from the base to the tip, n of them.
        links: the body moved by each joint, n of them.
        drives: motor, gear, friction and amplifier of each joint, n of them; empty without drive data.
        X_nM: mechanical interface frame in the frame of the last joint.
        dh: the DH table that the model was made from; empty otherwise.
        gravity: acceleration of free fall in the base frame [m/s²], shape (3,).
        home: joint coordinates of the rest position [rad | m], shape (n,).
        origins: where the numbers come from.
        base_shapes: what the part that stands still looks like, in the base frame.
    """

    name: str
    title: str
    joints: tuple[Joint, ...]
    links: tuple[Link, ...]
    drives: tuple[Drive, ...]
    X_nM: Pose
    home: Array
    dh: tuple[DhRow, ...] = ()
    gravity: Array = field(default_factory=lambda: frozen([0.0, 0.0, -9.81]))
    origins: tuple[ParameterOrigin, ...] = ()
    base_shapes: tuple[Shape, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "home", frozen(self.home))
        object.__setattr__(self, "gravity", frozen(self.gravity))

    @property
    def n(self) -> int:
        """Return the number of joints."""
        return len(self.joints)

    @property
    def lower_limits(self) -> Array:
        """Return the lower limits [rad | m], shape (n,)."""
        return frozen([joint.lower for joint in self.joints])

    @property
    def upper_limits(self) -> Array:
        """Return the upper limits [rad | m], shape (n,)."""
        return frozen([joint.upper for joint in self.joints])

    @property
    def max_speeds(self) -> Array:
        """Return the speed limits [rad/s | m/s], shape (n,)."""
        return frozen([joint.max_speed for joint in self.joints])

    @property
    def max_accelerations(self) -> Array:
        """Return the acceleration limits [rad/s² | m/s²], shape (n,)."""
        return frozen([joint.max_acceleration for joint in self.joints])

    @property
    def max_jerks(self) -> Array:
        """Return the jerk limits [rad/s³ | m/s³], shape (n,)."""
        return frozen([joint.max_jerk for joint in self.joints])

    @property
    def max_efforts(self) -> Array:
        """Return the torque or force limits at the joints [N·m | N], shape (n,)."""
        return frozen([joint.max_effort for joint in self.joints])
