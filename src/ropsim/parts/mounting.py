"""Tools of the library at another place than the mechanical interface, such as in front of an adapter."""

from dataclasses import replace

from ropsim.model import Gripper, Shape, moved
from ropsim.parts.part_kind import LibraryPart
from ropsim.spatial import Pose

_SAME = Pose()


def mounted(part: LibraryPart, X_MP: Pose) -> LibraryPart:
    """Return a tool whose frame P is at a pose in the mechanical interface frame M.

    Shapes, load, tool frame and fingers go along.

    Args:
        part: a tool as it is made, in its own frame.
        X_MP: its frame in M.
    """
    if X_MP == _SAME:
        return part
    return replace(
        part,
        shapes=_moved_shapes(part.shapes, X_MP),
        load=moved(part.load, X_MP),
        X_MT=None if part.X_MT is None else X_MP @ part.X_MT,
        gripper=None if part.gripper is None else _moved_gripper(part.gripper, X_MP),
    )


def _moved_shapes(shapes: tuple[Shape, ...], X_MP: Pose) -> tuple[Shape, ...]:
    return tuple(replace(shape, pose=X_MP @ shape.pose) for shape in shapes)


def _moved_gripper(gripper: Gripper, X_MP: Pose) -> Gripper:
    """Return a gripper whose fingers hang on the moved frame: their joints are those of the base."""
    fingers = gripper.fingers
    if fingers is None:
        return gripper
    joints = tuple(replace(one, placement=X_MP @ one.placement) for one in fingers.mechanism.joints)
    return replace(gripper, fingers=replace(fingers, mechanism=replace(fingers.mechanism, joints=joints)))
