"""Bodies of a cell that can support parts, and names of its bodies in messages."""

from ropsim.model.cell.body import WORLD, Body, BodyKind
from ropsim.model.cell.body_tree import BodyTree
from ropsim.model.cell.cell import Cell
from ropsim.model.cell.cell_bodies import body_tree
from ropsim.model.cell.surroundings import SupportLimits
from ropsim.model.robots.held_arm import carrying_links, external_links
from ropsim.model.robots.robot import RobotModel


def bearers(tree: BodyTree) -> tuple[str, ...]:
    """Return the names of the bodies on which parts can lie, in the order of the tree.

    Raises:
        MechanismError: the robot of a station has a coupling that mixes external axes with axes of its arm.
    """
    return tuple(body.name for body in tree.bodies if _bears(tree, body))


def carriages(tree: BodyTree) -> frozenset[str]:
    """Return the names of the links that carry the arm of a station: links that move the arm only.

    Raises:
        MechanismError: the robot of a station has a coupling that mixes external axes with axes of its arm.
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


def spoken_body(cell: Cell, name: str) -> str:
    """Return the name in messages of a body that carries parts: "the belt `feeder`", "the floor".

    Args:
        cell: the cell.
        name: of the body, `WORLD` for the floor.
    """
    if name == WORLD:
        return "the floor"
    tree = body_tree(cell)
    body = tree.by_name()[name]
    if body.kind is BodyKind.DEVICE:
        device = cell.devices[name.rpartition("/")[0]]
        return f"the belt `{device.name}`" if device.is_belt else f"`{device.name}`"
    if body.kind is BodyKind.LINK and body.mover:
        return _spoken_axis(tree, body.mover.mechanism, body.mover.joint, cell)
    return f"`{name}`"


def _spoken_axis(tree: BodyTree, owner: str, joint: int, cell: Cell) -> str:
    robot = tree.mechanisms[owner]
    if not isinstance(robot, RobotModel) or not robot.has_arm:
        return f"`{owner}`"
    key = "track" if joint in carrying_links(robot) else "positioner"
    return f"the {key}" + (f" of `{owner}`" if len(cell.stations) > 1 else "")


def lying_words(limits: SupportLimits) -> str:
    """Return a clause with the height above which a part is unsupported."""
    return f"a part counts as lying on what is at most {limits.gap * 1e3:g} mm below it"
