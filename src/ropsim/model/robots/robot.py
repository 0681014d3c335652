"""The neutral model of a robot: a mechanism with a mechanical interface, its limits and bare links."""

from dataclasses import replace
from math import inf

from ropsim.model.findings.diagnostics import UNUSABLE_LIMIT
from ropsim.model.findings.number_range import ModelValueError
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.model.mechanism.number_check import check_finite
from ropsim.model.robots.arm_class import ArmClass
from ropsim.model.robots.dh import DhRow
from ropsim.model.robots.published_path_limits import PublishedPathLimits
from ropsim.spatial import Array, Pose, record

LAST = -2
"""Tip of a robot that has its interface on its last link."""


@record
class RobotModel(Mechanism):
    """A mechanism with a mechanical interface; a serial arm has no couplings, no cuts and no branches.

    Attributes:
        X_nM: mechanical interface frame in the frame of the tip.
        tip: number of the link that carries the interface, from 0; `LAST` stands for the last one and is
            replaced by its number.
        dh: the DH table of the standard form that the model was made from; empty otherwise.
        external: numbers of the axes, from 0, that inverse kinematics leaves unchanged, such as a track or a
            turntable.
        rated_payload: mass that the maker allows at the interface, tool and part together [kg]; inf where
            unknown.
        arm_class: what it is built as, for rules of estimates; None where nothing but its axes says so.
        path_limits: of tool paths, as its maker publishes them; None where he says nothing.

    Raises:
        ModelValueError: the interface is not finite, the rated payload not positive; as `Mechanism`.
    """

    X_nM: Pose = Pose()
    tip: int = LAST
    dh: tuple[DhRow, ...] = ()
    external: tuple[int, ...] = ()
    rated_payload: float = inf
    arm_class: ArmClass | None = None
    path_limits: PublishedPathLimits | None = None

    __repr__ = Mechanism.__repr__

    def __post_init__(self) -> None:
        Mechanism.__post_init__(self)
        if self.tip == LAST:
            object.__setattr__(self, "tip", len(self.joints) - 1)
        check_finite(f"the mechanical interface of `{self.name}`", self.X_nM.as_tuple())
        if not self.rated_payload > 0.0:
            message = (
                f"`{self.name}` has a rated payload of {self.rated_payload:g} kg, allowed is more than 0"
            )
            raise ModelValueError(UNUSABLE_LIMIT.at(None, message, hint="leave it out where it is unknown"))

    @property
    def has_arm(self) -> bool:
        """Return whether it has axes that inverse kinematics moves; a station of one axis has no arm."""
        return len(self.external) < self.n

    @property
    def interface_link(self) -> int:
        """Return the number of the link that carries the mechanical interface."""
        return self.tip

    @property
    def interface(self) -> Pose:
        """Return the mechanical interface frame in the frame of that link."""
        return self.X_nM


def with_axis_limits(robot: RobotModel, speed: Array, acceleration: Array, jerk: Array) -> RobotModel:
    """Return a robot whose axes have these limits; the robot itself where they are its own.

    Args:
        robot: n axes.
        speed: [rad/s | m/s], shape (n,).
        acceleration: [rad/s² | m/s²], shape (n,).
        jerk: [rad/s³ | m/s³], shape (n,).
    """
    joints = list(robot.joints)
    for number, v, a, j in zip(robot.axes, speed, acceleration, jerk, strict=True):
        joints[number] = replace(
            joints[number], max_speed=float(v), max_acceleration=float(a), max_jerk=float(j)
        )
    return robot if tuple(joints) == robot.joints else replace(robot, joints=tuple(joints))


def is_bare(mechanism: Mechanism, number: int) -> bool:
    """Return whether a link is only a step between two joints.

    The link has no shape and no mass, and other links of its mechanism have shapes. In a mechanism without
    any shape nothing is known of any link.

    Args:
        mechanism: an arm with its external axes, or a device.
        number: of the link, from 0.
    """
    links = mechanism.links
    if number >= len(links):
        return False
    own = links[number]
    return not own.shapes and not own.mass and any(link.shapes for link in links)
