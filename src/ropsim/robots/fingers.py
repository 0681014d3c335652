"""Two fingers that open and close as one: the mechanism of a parallel gripper."""

import math

from ropsim.model import Box, Coupling, Fingers, Joint, JointType, Link, Material, Mechanism, Shape
from ropsim.spatial import Pose, frozen

_REACH = 0.012
"""By how much fingers reach beyond the TCP, over the top of a part, at most [m]."""
_RUBBER = "#2f363d"
_NONE = frozen([0.0] * 3)
_ANY = 1e3
"""Limit of speed, acceleration and jerk, which the dwell of the gripper decides."""


def parallel_fingers(X_MT: Pose, opened: float, closed: float, size: tuple[float, float, float]) -> Fingers:
    """Return two fingers on both sides of the TCP, apart along y of the tool frame.

    Args:
        X_MT: tool frame in the mechanical interface frame.
        opened: distance between the fingers of the open gripper [m].
        closed: distance when it has closed on nothing [m], below `opened`.
        size: of a finger along x, y and z of the tool frame [m].
    """
    breadth, thick, length = size
    solid = Box((breadth, length, thick))
    middle = min(_REACH, length / 4.0) - length / 2.0  # along z of the tool
    joints, links = [], []
    for name, side in (("finger", 1.0), ("other finger", -1.0)):
        # z of the joint points away from the other finger, along y of the tool or against it
        turn = Pose(_NONE, frozen([math.sqrt(0.5), -side * math.sqrt(0.5), 0.0, 0.0]))
        shape = Shape(
            solid, Pose(frozen([0.0, -side * middle, thick / 2.0])), _RUBBER, material=Material.RUBBER
        )
        limits = (closed / 2.0, opened / 2.0, _ANY, _ANY, _ANY)
        joints.append(Joint(name, JointType.PRISMATIC, X_MT @ turn, 0.0, *limits, parent=-1))
        links.append(Link(0.0, _NONE, frozen([[0.0] * 3] * 3), (shape,)))
    mechanism = Mechanism(
        "fingers",
        "Parallel gripper",
        tuple(joints),
        tuple(links),
        (),
        frozen([opened / 2.0]),
        axes=(0,),
        couplings=(Coupling(1, ((0, 1.0),)),),
    )
    return Fingers(mechanism, opened / 2.0, closed / 2.0)
