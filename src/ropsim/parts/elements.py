"""Common elements of library parts: colours, places, blocks and parameters that several kinds have."""

import math

from ropsim.model import Box, Cylinder, Material, Shape
from ropsim.parts.part_kind import Measure, Parameter
from ropsim.spatial import Pose, frozen

DARK, BODY, STEEL, RUBBER, WOOD = "#3d464f", "#59626b", "#a3abb3", "#2f363d", "#c3a06c"
LIGHT_TOP = "#d9d5cb"

_HALF = math.sqrt(0.5)
ALONG_Y = frozen([_HALF, -_HALF, 0.0, 0.0])
"""Turn that takes z to y: Rx(-90°)."""
ALONG_X = frozen([_HALF, 0.0, _HALF, 0.0])
"""Turn that takes z to x: Ry(90°)."""


def at(x: float, y: float, z: float) -> Pose:
    """Return a place without a turn [m]."""
    return Pose(frozen([x, y, z]))


def block(
    size: tuple[float, float, float],
    middle: tuple[float, float, float],
    colour: str,
    material: Material = Material.PAINT,
) -> Shape:
    """Return a box of edges along the axes [m] about a point [m]."""
    return Shape(Box(size), at(*middle), colour, material=material)


def upright(
    radius: float,
    low: float,
    high: float,
    colour: str,
    material: Material = Material.PAINT,
    x: float = 0.0,
    y: float = 0.0,
) -> Shape:
    """Return a cylinder along z from one height to another [m], about the line through `x` and `y` [m]."""
    return Shape(Cylinder(radius, high - low), at(x, y, 0.5 * (low + high)), colour, material=material)


def length_of(name: str, default: float, low: float, high: float, meaning: str) -> Parameter:
    """Return an estimated length [m]."""
    return Parameter(name, Measure.LENGTH, default, low, high, meaning)


def tool_parameters(mass: float, open_time: float, close_time: float) -> tuple[Parameter, ...]:
    """Return mass, centre of mass and times of a gripper, all estimated.

    Args:
        mass: default [kg].
        open_time: default [s].
        close_time: default [s].
    """
    com = "Distance of the centre of mass from the mechanical interface; without it that of the shapes."
    return (
        Parameter("mass", Measure.MASS, mass, 0.01, 100.0, "Mass of the whole."),
        Parameter("com", Measure.LENGTH, None, 0.0, 1.0, com),
        Parameter("open_time", Measure.TIME, open_time, 0.0, 10.0, "Time that opening takes."),
        Parameter("close_time", Measure.TIME, close_time, 0.0, 10.0, "Time that closing takes."),
    )
