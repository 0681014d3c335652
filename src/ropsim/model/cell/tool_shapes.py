"""The shapes of a tool: its own, or a bracket to its TCP with two fingers or a tip.

Views draw these shapes and collisions are checked with them.
"""

from itertools import pairwise

import numpy as np

from ropsim.model.cell.cell import Cell
from ropsim.model.cell.tool import Tool
from ropsim.model.geometry.elements import Box, Cylinder, Material, Prism, Revolve, Shape, Sphere
from ropsim.model.geometry.rod import rod
from ropsim.model.robots.robot import RobotModel
from ropsim.spatial import Array, Pose, quaternion_from_matrix

_BRACKET = "#59626b"
_STEEL = "#aab2ba"
_PAD = "#2f363d"
_SHORTEST = 2e-3  # [m]
_WIDTH = 0.04  # [m], between the fingers if no part determines it
_OVERLAP = 0.012  # [m], by which fingers reach beyond the TCP and so over the top face of a part


def grip_width(cell: Cell) -> float:
    """Return the distance between the fingers of a stand-in [m].

    That is the shorter side of the narrowest part, within 4 to 120 mm.
    """
    narrowest = min((float(min(part.size[:2])) for part in cell.parts), default=_WIDTH)
    return min(max(narrowest, 0.004), 0.12)


def flange_height(robot: RobotModel) -> float:
    """Return how far the last link of an arm reaches along z of the mechanical interface [m].

    The mechanical interface of some models lies in the wrist centre; a tool begins in front of the flange.
    The height is 0 where the link has no known shape.
    """
    shapes = robot.links[robot.tip].shapes if 0 <= robot.tip < len(robot.links) else ()
    along = robot.X_nM.rotation()[:, 2]
    origin = float(along @ robot.X_nM.position)
    return max([0.0, *(_support(shape, along) - origin for shape in shapes)])


def tool_shapes(tool: Tool, width: float, height: float = 0.0) -> tuple[Shape, ...]:
    """Return the shapes of a tool in the mechanical interface frame.

    A tool without shapes of its own gets a stand-in: a bracket along z of the interface and then across to
    the TCP, which it reaches along the approach direction, z of the tool frame.

    Args:
        tool: with or without shapes.
        width: distance between the fingers of a gripper [m].
        height: where the bracket begins on z of the interface [m]; 0 where the TCP lies below that.
    """
    if tool.look:
        return tool.look
    tip = tool.X_MT.position
    approach = tool.X_MT.rotation()[:, 2]
    distance = float(np.linalg.norm(tip))
    if distance < _SHORTEST:
        return ()
    radius = min(max(0.1 * distance, 0.004), 0.02)
    if tool.gripper is None:
        neck = tip - 0.35 * distance * approach
        return (
            *_bracket(neck, radius, height),
            rod(neck, tip, 0.8 * radius, 0.1 * radius, _STEEL, Material.STEEL),
        )
    length = min(max(0.3 * distance, 0.01), 0.06)
    palm = tip - length * approach
    drawn = _fingers(tool.X_MT, length, width, radius)
    return (*_bracket(palm, radius, height), *(drawn[:1] if tool.fingers else drawn))


def _bracket(end: Array, radius: float, height: float) -> tuple[Shape, ...]:
    """Return rods from a height along z of the interface, then straight to `end` [m], shape (3,)."""
    corner = np.array([0.0, 0.0, end[2]])
    start = np.array([0.0, 0.0, height if height < end[2] else 0.0])
    points = [start, corner, end]
    return tuple(
        rod(first, last, radius, None, _BRACKET, Material.STEEL)
        for first, last in pairwise(points)
        if float(np.linalg.norm(last - first)) > _SHORTEST
    )


def _fingers(X_MT: Pose, length: float, width: float, radius: float) -> tuple[Shape, ...]:
    """Return a palm across the approach direction and a finger on each side, apart along y of the tool."""
    thick = min(max(0.12 * width, 0.002), 0.006)
    breadth = max(1.2 * radius, 0.006)
    reach = min(_OVERLAP, 0.3 * width)
    palm = Box((1.6 * breadth, width + 4.0 * thick, 0.5 * length))
    finger = Box((breadth, thick, 0.8 * length + reach))
    shapes_of_parts = [(palm, (0.0, 0.0, -length), _BRACKET, Material.STEEL)]
    shapes_of_parts += [
        (finger, (0.0, side * (width + thick) / 2.0, reach - finger.size[2] / 2.0), _PAD, Material.RUBBER)
        for side in (1.0, -1.0)
    ]
    turn = quaternion_from_matrix(X_MT.rotation())
    rotation = X_MT.rotation()
    return tuple(
        Shape(solid, Pose(X_MT.position + rotation @ np.array(place), turn), colour, material=material)
        for solid, place, colour, material in shapes_of_parts
    )


def _support(shape: Shape, direction: Array) -> float:
    """Return how far a shape reaches along a direction of its body frame [m]; -inf for lines and meshes."""
    d = shape.pose.rotation().T @ direction
    across = float(np.hypot(d[0], d[1]))
    match shape.solid:
        case Box(size):
            own = 0.5 * float(np.abs(d) @ np.array(size))
        case Cylinder() as one:
            half = 0.5 * one.length
            own = max(one.radius * across - half * d[2], one.top_radius * across + half * d[2])
        case Sphere(radius):
            own = radius
        case Revolve(profile):
            own = max(r * across + z * d[2] for r, z in profile)
        case Prism(outline, length):
            own = max(x * d[0] + y * d[1] for x, y in outline) + max(0.0, length * d[2])
        case _:
            return -np.inf
    return float(direction @ shape.pose.position) + float(own)
