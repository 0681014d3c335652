"""Stations of one axis: a slide or a turntable with a drive, moved by a small program instead of a signal."""

from dataclasses import replace

import numpy as np

from ropsim.model import (
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    JointLimits,
    JointType,
    Link,
    Mechanism,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    Shape,
    limited,
)
from ropsim.robots.devices import rotary, slide
from ropsim.spatial import frozen, record

_GRAVITY = 9.81  # [m/s²], a slide may stand upright
_RESERVE = 1.5  # of the drive over the torque for load, rotor and friction
_ROTOR = 0.3  # of the load, inertia of the rotor seen at the axis
_DRY = 0.02  # of the weight of the load, dry friction of a slide
_DRY_TURNING = 0.05  # of the torque that accelerates the load, dry friction of a turntable
_RISE = 10.0  # [1/s], greatest jerk over greatest acceleration, as in the library
_RATIOS = {JointType.PRISMATIC: 200.0, JointType.REVOLUTE: 100.0}  # [rad/m | -]
_ESTIMATE = (
    ParameterOrigin(
        "drive",
        OriginKind.ESTIMATED,
        "made for the load, speed and acceleration of the axis, with half as much again",
    ),
)


@record
class AxisData:
    """Load of one axis, and its motion.

    Attributes:
        low: lower limit [rad | m].
        high: upper limit [rad | m].
        speed: limit [rad/s | m/s].
        acceleration: limit [rad/s² | m/s²].
        load: mass [kg] of the sliding bodies, or inertia about the axis [kg·m²] of the turning ones, with
            parts on them.
    """

    low: float
    high: float
    speed: float
    acceleration: float
    load: float


def driven_slide(shapes: tuple[Shape, ...], axis: AxisData) -> RobotModel:
    """Return a body that slides along x of the base frame under a drive: a robot whose one axis is external.

    Its interface is the base frame at coordinate 0, moved along.

    Args:
        shapes: of the body, in the base frame at coordinate 0.
        axis: limits and load.
    """
    body = Link(axis.load, np.zeros(3), np.zeros((3, 3)))
    return _driven(slide(shapes), "Slide", axis, body, _DRY * axis.load * _GRAVITY, axis.load * _GRAVITY)


def driven_rotary(shapes: tuple[Shape, ...], axis: AxisData) -> RobotModel:
    """Return a body that turns about z of the base frame under a drive: a robot whose one axis is external.

    Its interface is the base frame at coordinate 0, turned along.

    Args:
        shapes: of the body, in the base frame at coordinate 0.
        axis: limits and load.
    """
    half = axis.load / 2.0  # of a flat disc about the axes in its plane
    body = Link(0.0, np.zeros(3), np.diag([half, half, axis.load]))
    return _driven(rotary(shapes), "Turntable", axis, body, _DRY_TURNING * axis.load * axis.acceleration, 0.0)


def _driven(
    mechanism: Mechanism, title: str, axis: AxisData, body: Link, dry: float, weight: float
) -> RobotModel:
    """Return the robot of a mechanism with one joint.

    Args:
        mechanism: of one joint, without drive.
        title: of the robot.
        axis: limits and load.
        body: mass and inertia of the link.
        dry: friction at the axis [N·m | N].
        weight: greatest static load of the axis [N·m | N].
    """
    (joint,), (link,) = mechanism.joints, mechanism.links
    ratio = _RATIOS[joint.type]
    most = _RESERVE * ((1.0 + _ROTOR) * axis.load * axis.acceleration + weight + 2.0 * dry)
    limits = JointLimits(axis.low, axis.high, axis.speed, axis.acceleration, _RISE * axis.acceleration, most)
    friction = Friction(dry / (axis.speed * ratio**2), dry / ratio, -dry / ratio, 0.005)
    drive = Drive(
        EffortAmplifier(1.2 * most / ratio), IdealMotor(_ROTOR * axis.load / ratio**2), Gear(ratio), friction
    )
    return RobotModel(
        name=mechanism.name,
        title=title,
        joints=(limited("E1", joint.type, joint.placement, limits),),
        links=(replace(body, shapes=link.shapes),),
        drives=(drive,),
        home=frozen([min(max(0.0, axis.low), axis.high)]),
        origins=_ESTIMATE,
        base_shapes=mechanism.base_shapes,
        X_nM=joint.placement.inverse(),
        external=(0,),
    )
