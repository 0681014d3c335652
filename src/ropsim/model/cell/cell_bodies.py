"""From a cell to its bodies: robot, tools, fixed objects and parts, in the order of a scene."""

from collections.abc import Iterator

from ropsim.flow import ROBOT, prefix_of
from ropsim.model.cell.body import WORLD, Body, BodyKind, Mover
from ropsim.model.cell.body_tree import BodyTree
from ropsim.model.cell.cell import Cell
from ropsim.model.cell.cylinder_bodies import cylinder_bodies
from ropsim.model.cell.device import Device
from ropsim.model.cell.part import Part
from ropsim.model.cell.station import Station
from ropsim.model.cell.tool import Fingers
from ropsim.model.cell.tool_shapes import flange_height, grip_width, tool_shapes
from ropsim.model.geometry.elements import Box, Shape
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.spatial import Array, Pose, frozen

BASE = "base"
"""Name of the body of a robot that stands still."""


def body_tree(cell: Cell) -> BodyTree:
    """Return all bodies of a cell: base, links and tools of each station, devices, fixed objects, parts.

    The links are called `link1` to `linkN`, the tools `tool:NAME`, with the prefix of their station if it has
    a name (`left/link1`); objects and parts as in the cell.
    """
    width = grip_width(cell)
    stations = [body for one in cell.stations.values() for body in (*_robot(one), *_tools(one, width))]
    devices = [body for one in cell.devices.values() for body in _device(one)]
    mechanisms: dict[str, Mechanism] = {name: one.robot for name, one in cell.stations.items()}
    mechanisms |= {name: one.mechanism for name, one in cell.devices.items()}
    mechanisms |= {name: fingers.mechanism for name, fingers in fingers_of(cell).items()}
    return BodyTree((*stations, *devices, *_objects(cell), *_parts(cell)), mechanisms)


def start_of(cell: Cell) -> dict[str, Array]:
    """Return the joint coordinates at time 0 [rad | m], shape (n,), by mechanism."""
    start = {name: one.q_start for name, one in cell.stations.items()}
    start |= {name: frozen([one.q_start]) for name, one in cell.devices.items()}
    return start | {name: frozen([fingers.opened]) for name, fingers in fingers_of(cell).items()}


def fingers_of(cell: Cell) -> dict[str, Fingers]:
    """Return the fingers of all tools of a cell by the names of the bodies of the tools."""
    tools = (
        (tool_body(name, at.name), tool) for at in cell.stations.values() for name, tool in at.tools.items()
    )
    return {name: tool.fingers for name, tool in tools if tool.fingers}


def link_name(number: int, station: str = ROBOT) -> str:
    """Return the name of link `number` of a station, from 1; of link 0, the base."""
    return prefix_of(station) + (f"link{number}" if number else BASE)


def tool_body(name: str, station: str = ROBOT) -> str:
    """Return the name of the body of a tool of a station."""
    return f"{prefix_of(station)}tool:{name}"


def mount_of(device: Device) -> tuple[str, Pose]:
    """Return the body of a device that things hang on, and the frame in it that they are given in.

    That is its moving body, with the base frame at coordinate 0; of a belt its base, with the base frame.
    """
    if device.is_belt:
        return link_name(0, device.name), Pose()
    return link_name(1, device.name), device.mechanism.joints[0].placement.inverse()


def part_shape(part: Part) -> Shape:
    """Return the box of a part in its object frame, whose origin is the centre of the top face."""
    x, y, z = part.size.tolist()
    return Shape(Box((x, y, z)), Pose(frozen([0.0, 0.0, -z / 2.0])), part.colour, material=part.material)


def _robot(station: Station) -> Iterator[Body]:
    robot, name = station.robot, station.name
    yield Body(link_name(0, name), BodyKind.BASE, WORLD, station.X_WB, robot.base_shapes)
    yield from _links(robot, name, BodyKind.LINK)
    names = tuple(link_name(number, name) for number in range(len(robot.joints) + 1))
    yield from cylinder_bodies(robot, name, names)


def _device(device: Device) -> Iterator[Body]:
    mechanism, name = device.mechanism, device.name
    yield Body(link_name(0, name), BodyKind.DEVICE, WORLD, device.X_WB, mechanism.base_shapes)
    yield from _links(mechanism, name, BodyKind.DEVICE)


def _links(mechanism: Mechanism, name: str, kind: BodyKind) -> Iterator[Body]:
    for k, joint in enumerate(mechanism.joints):
        shapes = mechanism.links[k].shapes if k < len(mechanism.links) else ()
        parent, mover = link_name(joint.parent + 1, name), Mover(name, k)
        yield Body(link_name(k + 1, name), kind, parent, joint.placement, shapes, mover)


def _tools(station: Station, width: float) -> Iterator[Body]:
    last, X_nM = link_name(station.robot.tip + 1, station.name), station.robot.X_nM
    height = flange_height(station.robot)
    for name, tool in station.tools.items():
        mounted = name == station.default_tool
        body = tool_body(name, station.name)
        yield Body(body, BodyKind.TOOL, last, X_nM, tool_shapes(tool, width, height), visible=mounted)
        mechanism = tool.fingers.mechanism if tool.fingers else None
        for k, joint in enumerate(mechanism.joints if mechanism else ()):
            shapes = mechanism.links[k].shapes if mechanism else ()
            finger, mover = f"{body}/finger{k + 1}", Mover(body, k)
            yield Body(finger, BodyKind.FINGER, body, joint.placement, shapes, mover, mounted)


def _objects(cell: Cell) -> Iterator[Body]:
    for thing in cell.objects:
        yield Body(thing.name, BodyKind.OBJECT, thing.parent, thing.X_PO, thing.shapes)


def _parts(cell: Cell) -> Iterator[Body]:
    for part in cell.parts:
        shown = part.turn == 0
        yield Body(part.name, BodyKind.PART, WORLD, part.X_WO, (part_shape(part),), visible=shown)
