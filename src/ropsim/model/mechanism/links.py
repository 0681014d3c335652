"""Links, joints, couplings and loop cuts: the elements of a mechanism."""

from enum import Enum
from math import pi

from ropsim.core import frozen_dataclass
from ropsim.model.geometry.elements import Shape
from ropsim.spatial import Array, Pose, frozen, record


@record
class Link:
    """The rigid body that a joint moves; all quantities in the frame of that joint.

    Attributes:
        mass: [kg].
        com: centre of mass [m], shape (3,).
        inertia: inertia tensor about the centre of mass [kg·m²], shape (3, 3).
        shapes: its shapes; without any, views draw a stand-in.
    """

    mass: float
    com: Array
    inertia: Array
    shapes: tuple[Shape, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "com", frozen(self.com))
        object.__setattr__(self, "inertia", frozen(self.inertia))


BASE_LINK = -1
"""Parent of a joint that hangs on the base of its mechanism."""

PREVIOUS = -2
"""Parent of a joint that hangs on the link of the joint before it in the list, the first one on the base."""


WITHOUT_END = 400.0 * 2.0 * pi
"""Limit of a joint that turns without end [rad]; no program comes near to it."""
_ROUNDING = 1e-9  # relative, of limits that were written in degrees


class JointType(Enum):
    """The pair that a joint forms, and the motions of its coordinates, in order.

    A UNIVERSAL joint turns about its z axis, then about the turned x axis; a SPHERICAL one about z, the
    turned y, the turned x; a CYLINDRICAL one turns about z and slides along it; a PLANAR one slides along x
    and y and turns about z; a SCREW turns about z and advances along it by its lead in each turn.
    """

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"
    SCREW = "screw"
    CYLINDRICAL = "cylindrical"
    UNIVERSAL = "universal"
    SPHERICAL = "spherical"
    PLANAR = "planar"
    FIXED = "fixed"

    @property
    def freedoms(self) -> int:
        """Return how many coordinates a joint of this type has."""
        return _FREEDOMS[self]


_FREEDOMS = {
    JointType.REVOLUTE: 1,
    JointType.PRISMATIC: 1,
    JointType.SCREW: 1,
    JointType.CYLINDRICAL: 2,
    JointType.UNIVERSAL: 2,
    JointType.SPHERICAL: 3,
    JointType.PLANAR: 3,
    JointType.FIXED: 0,
}


@record
class Joint:
    """A joint; with one freedom it turns about or slides along the z axis of its own frame.

    Attributes:
        name: such as `1`.
        type: revolute, prismatic or another one.
        placement: fixed pose of the joint frame at coordinate 0 in the frame of the link that carries it.
        offset: added to the coordinate before it moves the joint [rad | m] (theta or d of the DH row); of a
            joint with more freedoms, to its first coordinate.
        lower: lower limit of the coordinate [rad | m].
        upper: upper limit [rad | m].
        max_speed: [rad/s | m/s].
        max_acceleration: [rad/s² | m/s²].
        max_jerk: [rad/s³ | m/s³].
        max_effort: largest torque or force at the joint [N·m | N]; inf where unknown.
        parent: number, from 0, of the link that carries the joint, `BASE_LINK` for the base, `PREVIOUS` for
            the link before; in a mechanism always one of the first two.
        lead: of a screw, advance along z in one turn [m]; signed.
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
    parent: int = PREVIOUS
    lead: float = 0.0

    @property
    def measure(self) -> JointType:
        """Return whether its first coordinate is an angle (REVOLUTE) or a length (PRISMATIC)."""
        slides = self.type in (JointType.PRISMATIC, JointType.PLANAR)
        return JointType.PRISMATIC if slides else JointType.REVOLUTE

    @property
    def is_endless(self) -> bool:
        """Return whether it turns without end."""
        least = (1.0 - _ROUNDING) * WITHOUT_END
        return self.type is JointType.REVOLUTE and self.lower <= -least and self.upper >= least


@frozen_dataclass
class Coupling:
    """One coordinate as an exact linear function of others: q_dependent = Σ factor · q_other + constant.

    Coordinates are counted from 0, joint by joint; a joint has as many as its type has freedoms.

    Attributes:
        dependent: number of the coordinate that follows.
        terms: pairs of another coordinate's number and its factor, with the units of both.
        constant: [rad | m].
    """

    dependent: int
    terms: tuple[tuple[int, float], ...]
    constant: float = 0.0


class Direction(Enum):
    """A way in which two frames could part: along or about an axis of the first one."""

    X = "x"
    Y = "y"
    Z = "z"
    ABOUT_X = "about x"
    ABOUT_Y = "about y"
    ABOUT_Z = "about z"


ALL_DIRECTIONS = tuple(Direction)


@record
class LoopCut:
    """Two frames on two bodies that a closed chain holds together.

    Attributes:
        first: number of a link from 0, `BASE_LINK` for the base.
        X_first: frame on it.
        second: number of another link.
        X_second: frame on that one.
        held: directions in which the two frames cannot part; the others are the freedoms of the cut joint.
    """

    first: int
    X_first: Pose
    second: int
    X_second: Pose
    held: tuple[Direction, ...] = ALL_DIRECTIONS
