"""On which bodies of a cell parts can lie: fixed objects, devices, and links that external axes move."""

from ropsim.model.body import Body, BodyKind
from ropsim.model.body_tree import BodyTree
from ropsim.model.held_arm import carrying_links, external_links
from ropsim.model.robot import RobotModel


def bearers(tree: BodyTree) -> tuple[str, ...]:
    """Return the names of the bodies on which parts can lie, in the order of the tree.

    Raises:
        MechanismError: the robot of a station has a coupling that mixes external axes with those of its arm.
    """
    return tuple(body.name for body in tree.bodies if _bears(tree, body))


def carriages(tree: BodyTree) -> frozenset[str]:
    """Return the names of the links that carry the arm of a station: what moves the arm, and nothing else.

    Raises:
        MechanismError: the robot of a station has a coupling that mixes external axes with those of its arm.
    """
    return frozenset(body.name for body in tree.bodies if _carries_an_arm(tree, body))


def _bears(tree: BodyTree, body: Body) -> bool:
    if body.kind is not BodyKind.LINK:
        return body.kind in {BodyKind.OBJECT, BodyKind.DEVICE}
    robot = tree.mechanisms[body.mover.mechanism] if body.mover else None
    if not isinstance(robot, RobotModel) or not robot.external or body.mover is None:
        return False
    return body.mover.joint in external_links(robot)


def _carries_an_arm(tree: BodyTree, body: Body) -> bool:
    robot = tree.mechanisms[body.mover.mechanism] if body.mover else None
    if body.kind is not BodyKind.LINK or not isinstance(robot, RobotModel):
        return False
    if not robot.external or not robot.has_arm:
        return False
    return body.mover is not None and body.mover.joint in carrying_links(robot)
