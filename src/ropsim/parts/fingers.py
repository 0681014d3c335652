"""Two fingers that open and close as one: the mechanism of a parallel gripper."""

from dataclasses import replace

from ropsim.model import Box, Coupling, Fingers, Joint, JointType, Link, Material, Mechanism, Shape
from ropsim.parts.elements import RUBBER
from ropsim.spatial import ALONG_Y, Pose, frozen

_REACH = 0.012
"""By how much fingers reach beyond the TCP, over the top of a part, at most [m]."""
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
    middle = min(_REACH, length / 4.0) - length / 2.0  # along z of the tool
    solid = Box((breadth, length, thick))

    def shapes(side: float) -> tuple[Shape, ...]:
        place = Pose(frozen([0.0, -side * middle, thick / 2.0]))
        return (Shape(solid, place, RUBBER, material=Material.RUBBER),)

    return _moving(X_MT, opened, closed, (shapes(1.0), shapes(-1.0)))


def shaped_fingers(X_MT: Pose, opened: float, closed: float, finger: tuple[Shape, ...]) -> Fingers:
    """Return two equal fingers on both sides of the TCP, apart along y of the tool frame.

    Args:
        X_MT: tool frame in the mechanical interface frame.
        opened: distance between the fingers of the open gripper [m].
        closed: distance when it has closed on nothing [m], below `opened`.
        finger: shapes of the finger on the side of +y, at distance 0: in the tool frame, with y >= 0. The
            other one is the same, turned by half a turn about z.
    """
    half = Pose(_NONE, frozen([0.0, 0.0, 0.0, 1.0]))
    other = tuple(replace(shape, pose=half @ shape.pose) for shape in finger)
    sides = tuple(
        tuple(replace(shape, pose=_along(side).inverse() @ shape.pose) for shape in shapes)
        for side, shapes in ((1.0, finger), (-1.0, other))
    )
    return _moving(X_MT, opened, closed, (sides[0], sides[1]))


def _along(side: float) -> Pose:
    """Return the frame whose z axis points along y of the tool, or against it for the side -1."""
    return ALONG_Y if side > 0.0 else ALONG_Y.inverse()


def _moving(
    X_MT: Pose, opened: float, closed: float, shapes: tuple[tuple[Shape, ...], tuple[Shape, ...]]
) -> Fingers:
    """Return fingers with shapes in the frames of their joints, which point away from the other finger."""
    joints, links = [], []
    for name, side, own in (("finger", 1.0, shapes[0]), ("other finger", -1.0, shapes[1])):
        limits = (closed / 2.0, opened / 2.0, _ANY, _ANY, _ANY)
        joints.append(Joint(name, JointType.PRISMATIC, X_MT @ _along(side), 0.0, *limits, parent=-1))
        links.append(Link(0.0, _NONE, frozen([[0.0] * 3] * 3), own))
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
