"""Serial arms whose makers count a joint with others: each coupled axis is a massless crank next to the arm.

FANUC counts joint 3 from the horizontal, and in arms with a parallelogram the motor of axis 3 holds the
forearm against the column: the joint between lower arm and forearm turns by its axis and by axis 2. The axis
is then a joint of its own behind all others, a *crank* that stands where the joint that it is counted with
stands, and the joint of the chain follows both by a coupling.
"""

from dataclasses import replace
from math import cos, inf, sin

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model.mechanism.links import Coupling, Joint, JointType, Link
from ropsim.model.mechanism.placements import snapped
from ropsim.model.robots.robot import RobotModel
from ropsim.spatial import Pose, frozen


@frozen_dataclass
class CoupledAxis:
    """An axis that moves its joint together with others.

    Attributes:
        joint: number of the joint in the chain, from 0.
        others: numbers of axes before it and their factors: the joint is at q_joint + Σ factor · q_other.
        lower: limit of the joint itself [rad | m]; -inf for none.
        upper: the same [rad | m]; inf for none.
    """

    joint: int
    others: tuple[tuple[int, float], ...]
    lower: float
    upper: float


def with_coupled_axes(robot: RobotModel, axes: tuple[CoupledAxis, ...]) -> RobotModel:
    """Return a serial arm with axes that move their joints together with others.

    Args:
        robot: serial arm with n joints, which are its axes, with the limits of the axes.
        axes: that are coupled; the joints behind the chain are in this order.
    """
    joints, links = list(robot.joints), list(robot.links)
    places = list(range(robot.n))
    for number, axis in enumerate(axes):
        places[axis.joint] = robot.n + number
    couplings = []
    for axis in axes:
        own, beside = robot.joints[axis.joint], robot.joints[axis.others[0][0]]
        joints.append(replace(own, placement=_crank(robot, axis), offset=0.0, parent=beside.parent))
        joints[axis.joint] = replace(
            own, name=_sum(robot, axis), lower=axis.lower, upper=axis.upper, max_effort=inf
        )
        links.append(Link(0.0, frozen(np.zeros(3)), frozen(np.zeros((3, 3)))))
        terms = ((places[axis.joint], 1.0), *((places[other], factor) for other, factor in axis.others))
        couplings.append(Coupling(axis.joint, terms))
    return replace(
        robot,
        joints=tuple(joints),
        links=tuple(links),
        axes=tuple(places),
        couplings=tuple(couplings),
        tip=robot.n - 1,
        dh=(),
    )


def without_coupled_axes(robot: RobotModel) -> tuple[RobotModel, tuple[CoupledAxis, ...]]:
    """Return the serial arm and the axes of which `with_coupled_axes` makes a robot.

    The robot itself and no axes, if the result is not a robot of this kind.
    """
    n, places = robot.n, robot.axes
    numbers = {place: axis for axis, place in enumerate(places)}
    behind = [coupling for coupling in robot.couplings if coupling.dependent < n]
    if robot.cuts or not {*places, *(one.dependent for one in behind)} >= set(range(n)):
        return robot, ()
    axes = []
    for coupling in behind:
        others = tuple((numbers.get(place, n), factor) for place, factor in coupling.terms[1:])
        if not others or max(other for other, _ in others) >= coupling.dependent:
            return robot, ()
        joint = robot.joints[coupling.dependent]
        axes.append(CoupledAxis(coupling.dependent, others, joint.lower, joint.upper))
    joints = list(robot.joints[:n])
    for axis in axes:
        own, limits = joints[axis.joint], robot.joints[places[axis.joint]]
        joints[axis.joint] = replace(limits, placement=own.placement, offset=own.offset, parent=own.parent)
    serial = replace(robot, joints=tuple(joints), links=robot.links[:n], axes=tuple(range(n)), couplings=())
    return (serial, tuple(axes)) if axes and with_coupled_axes(serial, tuple(axes)) == robot else (robot, ())


def _sum(robot: RobotModel, axis: CoupledAxis) -> str:
    """Return a joint in coordinates of a pendant, as `J3 + J2`."""
    words = robot.joints[axis.joint].name
    for other, factor in axis.others:
        times = "" if abs(factor) == 1.0 else f"{abs(factor):g}·"
        words += f" {'-' if factor < 0.0 else '+'} {times}{robot.joints[other].name}"
    return words


def _crank(robot: RobotModel, axis: CoupledAxis) -> Pose:
    """Return the frame of a crank on the link that carries the coupled joint, turned as its joint is."""
    beside = axis.others[0][0]
    X = robot.joints[beside].placement
    turned = X
    for number in range(beside, axis.joint):
        turned = turned @ _moved(robot.joints[number]) @ robot.joints[number + 1].placement
    return Pose.from_matrix(snapped(Pose(X.position, turned.orientation).matrix()))


def _moved(joint: Joint) -> Pose:
    """Return the motion of a joint at coordinate 0, which is that of its offset."""
    if joint.type is JointType.PRISMATIC:
        return Pose(np.array([0.0, 0.0, joint.offset]))
    half = 0.5 * joint.offset
    return Pose(orientation=frozen([cos(half), 0.0, 0.0, sin(half)]))
