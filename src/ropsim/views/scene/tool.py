"""How a tool is drawn: by its own shapes, or by a bracket to its TCP with two fingers or a tip."""

from itertools import pairwise

import numpy as np

from ropsim.model import Box, Cell, Material, Shape, Tool, rod
from ropsim.spatial import Array, Pose, quaternion_from_matrix

_BRACKET = "#59626b"
_STEEL = "#aab2ba"
_PAD = "#2f363d"
_SHORTEST = 2e-3  # [m]
_WIDTH = 0.04  # [m], between the fingers where no part tells
_OVERLAP = 0.012  # [m], by which fingers reach beyond the TCP and so over the top face of a part


def grip_width(cell: Cell) -> float:
    """Return the distance of drawn fingers: the narrowest part's shorter side, within 4 to 120 mm [m]."""
    narrowest = min((float(min(part.size[:2])) for part in cell.parts), default=_WIDTH)
    return min(max(narrowest, 0.004), 0.12)


def tool_shapes(tool: Tool, width: float) -> tuple[Shape, ...]:
    """Return what a tool looks like in the mechanical interface frame.

    The stand-in is a bracket along z of the interface and then across to the TCP, which it reaches along the
    approach direction, z of the tool frame.

    Args:
        tool: with or without shapes.
        width: distance between the fingers of a gripper [m].
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
        return (*_bracket(neck, radius), rod(neck, tip, 0.8 * radius, 0.1 * radius, _STEEL, Material.STEEL))
    length = min(max(0.3 * distance, 0.01), 0.06)
    palm = tip - length * approach
    drawn = _fingers(tool.X_MT, length, width, radius)
    return (*_bracket(palm, radius), *(drawn[:1] if tool.fingers else drawn))


def _bracket(end: Array, radius: float) -> tuple[Shape, ...]:
    """Return rods from the interface along its z, then straight to `end` [m], shape (3,)."""
    corner = np.array([0.0, 0.0, end[2]])
    points = [np.zeros(3), corner, end]
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
    pieces = [(palm, (0.0, 0.0, -length), _BRACKET, Material.STEEL)]
    pieces += [
        (finger, (0.0, side * (width + thick) / 2.0, reach - finger.size[2] / 2.0), _PAD, Material.RUBBER)
        for side in (1.0, -1.0)
    ]
    turn = quaternion_from_matrix(X_MT.rotation())
    rotation = X_MT.rotation()
    return tuple(
        Shape(solid, Pose(X_MT.position + rotation @ np.array(place), turn), colour, material=material)
        for solid, place, colour, material in pieces
    )
