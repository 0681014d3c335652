"""What messages call the bodies of a cell: a device by its name, an external axis by its key."""

from ropsim.model.body import WORLD, BodyKind
from ropsim.model.body_tree import BodyTree
from ropsim.model.cell import Cell
from ropsim.model.cell_bodies import body_tree
from ropsim.model.held_arm import carrying_links
from ropsim.model.robot import RobotModel
from ropsim.model.surroundings import SupportLimits


def spoken_body(cell: Cell, name: str) -> str:
    """Return what a message calls a body that carries parts: "the belt `feeder`", "the floor".

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
    """Return from what height on a part lies on nothing, as a clause."""
    return f"a part counts as lying on what is at most {limits.gap * 1e3:g} mm below it"
