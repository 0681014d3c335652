"""The class of an arm: as the arm says, else by its axes."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.model import ArmClass, Joint, JointType, RobotModel
from ropsim.robotfile.estimation.joint_centres import rest_frames
from ropsim.spatial import Array

_PARALLEL = 1e-6  # sine of the angle between parallel axes
_COBOT_AXES = 6
_SEVEN = 7
_LEVEL_BODIES = 5  # from column to flange: column, lower arm, forearm, wrist, flange


def arm_class_of(robot: RobotModel) -> ArmClass:
    """Return the class of an arm.

    An arm without a stated class is classified by its axes: parallelograms that keep the flange level make
    a palletizer, parallel axes of which one slides a SCARA arm, seven turning axes a seven-axis arm, six
    turning axes with axes 2, 3 and 4 parallel a cobot. Every other arm is an industrial one.
    """
    if robot.arm_class is not None:
        return robot.arm_class
    if robot.couplings and level_chain(robot):
        return ArmClass.PALLETIZER
    return class_of_joints(robot.axis_joints if robot.couplings else robot.joints)


def class_of_joints(joints: Sequence[Joint]) -> ArmClass:
    """Return the class of a serial arm by its axes.

    Args:
        joints: from the base on.
    """
    axes, slides = (
        rest_frames(joints)[:, :3, 2],
        [joint.type is JointType.PRISMATIC for joint in joints],
    )
    if any(slides) and not all(slides) and all(_is_parallel(*pair) for pair in pairwise(axes)):
        return ArmClass.SCARA
    if len(joints) == _SEVEN and not any(slides):
        return ArmClass.SEVEN_AXIS
    elbow = all(_is_parallel(*pair) for pair in pairwise(axes[1:4]))
    if len(joints) == _COBOT_AXES and not any(slides) and elbow:
        return ArmClass.COBOT
    return ArmClass.INDUSTRIAL


def level_chain(robot: RobotModel) -> tuple[int, ...]:
    """Return the bodies of a palletizer from the column to the flange; nothing if it is none.

    A palletizer has four axes, which turn column, lower arm, crank of the forearm and flange. Column, lower
    arm, forearm, wrist and flange are a chain of joints, the crank of axis 3 hangs on the column, and
    couplings move the joints that are no axes.
    """
    way, number = [], robot.tip
    while number >= 0:
        way.append(number)
        number = robot.joints[number].parent
    chain = tuple(reversed(way))
    if len(chain) != _LEVEL_BODIES or len(robot.axes) != _LEVEL_BODIES - 1:
        return ()
    column, arm, crank, flange = robot.axes
    on_column = robot.joints[crank].parent == column and crank not in chain
    return chain if (column, arm, flange) == (*chain[:2], chain[-1]) and on_column else ()


def _is_parallel(one: Array, other: Array) -> bool:
    return float(np.linalg.norm(np.cross(one, other))) < _PARALLEL
