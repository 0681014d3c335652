"""What comes of keeping the limits: a slowed motion with its places, or the place where no speed can do."""

from typing import Protocol

from ropsim.motion.limits.joint_bounds import Quantity
from ropsim.motion.limits.motion_time import MotionTime
from ropsim.motion.limits.ways import Ways
from ropsim.motion.paths.path import JointPoints
from ropsim.spatial import Array, record


class Motion(Protocol):
    """A planned motion over motion time φ, at rest at both ends, within the limits of its paths."""

    @property
    def duration(self) -> float:
        """Return the motion time of the end [s]."""

    def at(self, phi: Array) -> JointPoints:
        """Return the coordinates at motion times [s], (k,), and their derivatives by φ.

        The arrays are new; whoever asks may write to them.
        """

    def ways(self, phi: Array) -> Ways:
        """Return how paths with limits of their own are walked at motion times [s], rising, (k,)."""


@record
class Slowed:
    """A part of a motion that goes slower than it was planned.

    Attributes:
        start: motion time at which slowing begins [s].
        end: motion time at which the plan's speed is there again [s].
        share: least rate in between, in ]0, 1[.
        joint: index of the joint that the plan asks too much of, most of all between the two.
        quantity: what it asks too much of.
    """

    start: float
    end: float
    share: float
    joint: int
    quantity: Quantity


@record
class Kept:
    """A motion within its limits at every control tick.

    Attributes:
        clock: motion time over real time.
        slowed: the parts that are slowed, in order; none where the plan is within the limits.
        phi: motion times at the control ticks 0, 1, 2 … until it rests, see `Ticks` [s], shape (k,).
        rows: coordinates, speeds and accelerations by real time there; a plan that takes them over ends with
            them exactly at rest.
    """

    clock: MotionTime
    slowed: tuple[Slowed, ...]
    phi: Array
    rows: JointPoints


@record
class Beyond:
    """The first place at which no speed keeps the limits.

    Attributes:
        phi: motion time of the place [s].
        joint: index of the joint.
        quantity: what is too much for it.
        value: how much of that it would take [unit of the quantity], at the least speed that counts.
        limit: what the joint can do.
    """

    phi: float
    joint: int
    quantity: Quantity
    value: float
    limit: float
