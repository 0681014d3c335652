"""From a cell to its bodies: robot, tools, fixed objects and parts, in the order of a scene."""

from collections.abc import Iterator

from ropsim.model.body import WORLD, Body, BodyKind, Mover
from ropsim.model.body_tree import BodyTree
from ropsim.model.cell import Cell, Part
from ropsim.model.geometry import Box, Shape
from ropsim.spatial import Array, Pose, frozen

ROBOT = "robot"
"""Name of the mechanism that is the robot of a cell."""

BASE = "base"
"""Name of the body of a robot that stands still."""


def body_tree(cell: Cell) -> BodyTree:
    """Return all bodies of a cell: base, links, tools, fixed objects, parts.

    The links are called `link1` to `linkN`, the tools `tool:NAME`, objects and parts as in the cell.
    """
    return BodyTree((*_robot(cell), *_tools(cell), *_objects(cell), *_parts(cell)), {ROBOT: cell.robot})


def start_of(cell: Cell) -> dict[str, Array]:
    """Return the joint coordinates at time 0 [rad | m], shape (n,), by mechanism."""
    return {ROBOT: cell.start if len(cell.start) else cell.robot.home}


def link_name(number: int) -> str:
    """Return the name of link `number`, from 1; of link 0, the base."""
    return f"link{number}" if number else BASE


def tool_body(name: str) -> str:
    """Return the name of the body of a tool."""
    return f"tool:{name}"


def part_shape(part: Part) -> Shape:
    """Return the box of a part in its object frame, whose origin is the centre of the top face."""
    x, y, z = part.size.tolist()
    return Shape(Box((x, y, z)), Pose(frozen([0.0, 0.0, -z / 2.0])), part.colour, material=part.material)


def _robot(cell: Cell) -> Iterator[Body]:
    robot = cell.robot
    yield Body(BASE, BodyKind.BASE, WORLD, cell.X_WB, robot.base_shapes)
    for k, joint in enumerate(robot.joints):
        shapes = robot.links[k].shapes if k < len(robot.links) else ()
        mover = Mover(ROBOT, k)
        yield Body(
            link_name(k + 1), BodyKind.LINK, link_name(joint.parent + 1), joint.placement, shapes, mover
        )


def _tools(cell: Cell) -> Iterator[Body]:
    last, X_nM = link_name(cell.robot.tip + 1), cell.robot.X_nM
    for name, tool in cell.tools.items():
        mounted = name == cell.default_tool
        yield Body(tool_body(name), BodyKind.TOOL, last, X_nM, tool.shapes, visible=mounted)


def _objects(cell: Cell) -> Iterator[Body]:
    for thing in cell.objects:
        yield Body(thing.name, BodyKind.OBJECT, thing.parent, thing.X_PO, thing.shapes)


def _parts(cell: Cell) -> Iterator[Body]:
    for part in cell.parts:
        shown = part.turn == 0
        yield Body(part.name, BodyKind.PART, WORLD, part.X_WO, (part_shape(part),), visible=shown)
