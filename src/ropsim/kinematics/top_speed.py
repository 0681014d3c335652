"""A speed that no motion of an arm exceeds, in any posture."""

from math import hypot, inf

import numpy as np

from ropsim.model import BASE_LINK, Joint, JointType, RobotModel
from ropsim.spatial import Array

_KNOWN = (JointType.REVOLUTE, JointType.PRISMATIC, JointType.FIXED)


def speed_bound(robot: RobotModel, p_M: Array) -> float:
    """Return a speed [m/s] that a point of the mechanical interface never exceeds in the base frame.

    v ≤ Σ q̇ᵢ·rᵢ over the turning joints, rᵢ the length of the chain from axis i to the point, and Σ q̇ᵢ over
    the sliding ones, each q̇ᵢ the speed limit of its joint. The parts of a chain are seldom all stretched and
    moving the same way, so an arm attains less.

    Args:
        robot: the arm, its external axes included.
        p_M: the point in the mechanical interface frame [m], shape (3,).

    Returns:
        The bound; inf where a joint of the chain is no axis, has more than one freedom, or has no limit.
    """
    chain: list[int] = []
    number = robot.interface_link
    while number != BASE_LINK:
        chain.append(number)
        number = robot.joints[number].parent
    at = robot.interface.position + robot.interface.rotation() @ np.asarray(p_M, dtype=np.float64)
    radius, length = hypot(float(at[0]), float(at[1])), float(np.linalg.norm(at))
    total = 0.0
    for number in chain:
        joint = robot.joints[number]
        if joint.type not in _KNOWN or (joint.type is not JointType.FIXED and number not in robot.axes):
            return inf
        if joint.type is JointType.REVOLUTE:
            total += joint.max_speed * radius
        elif joint.type is JointType.PRISMATIC:
            total += joint.max_speed
        x, y, z = joint.placement.position.tolist()
        travel = _travel(joint)
        radius, length = hypot(x, y) + length + travel, hypot(x, y, z) + length + travel
    return total


def _travel(joint: Joint) -> float:
    """Return the travel of the link of a joint from its drawn place [m]."""
    if joint.type is not JointType.PRISMATIC:
        return 0.0
    return max(abs(joint.lower + joint.offset), abs(joint.upper + joint.offset))
