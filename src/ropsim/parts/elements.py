"""Common elements of library parts: colours, places, blocks and parameters that several kinds have."""

from ropsim.model import DARK_GREY, STEEL_GREY, Box, Cylinder, Material, Shape
from ropsim.parts.part_kind import TCP, Measure, Parameter
from ropsim.spatial import translation

HOUSING, RUBBER, WOOD, LIGHT_TOP = "#59626b", "#2f363d", "#c3a06c", "#d9d5cb"
ADAPTER = 0.012
"""Thickness of the adapter plate of a gripper [m]."""


def block(
    size: tuple[float, float, float],
    middle: tuple[float, float, float],
    colour: str,
    material: Material = Material.PAINT,
) -> Shape:
    """Return a box of edges along the axes [m] about a point [m]."""
    return Shape(Box(size), translation(*middle), colour, material=material)


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
    return Shape(
        Cylinder(radius, high - low), translation(x, y, 0.5 * (low + high)), colour, material=material
    )


def adapter_plate(diameter: float) -> tuple[Shape, Shape]:
    """Return a plate of a diameter [m] and thickness `ADAPTER` on the mechanical interface."""
    radius = diameter / 2.0
    return (
        upright(radius, 0.0, 0.7 * ADAPTER, STEEL_GREY, Material.STEEL),
        upright(0.8 * radius, 0.7 * ADAPTER, ADAPTER, DARK_GREY),
    )


def housing(size: tuple[float, float, float], cover: tuple[float, float, float]) -> tuple[Shape, Shape]:
    """Return the housing of a gripper in front of its adapter plate.

    Args:
        size: its edges along x, y and z [m].
        cover: edges of the cover that looks out of it, in shares of `size`.
    """
    middle = (0.0, 0.0, ADAPTER + size[2] / 2.0)
    x, y, z = (share * edge for share, edge in zip(cover, size, strict=True))
    return block(size, middle, HOUSING), block((x, y, z), middle, DARK_GREY)


def length_of(name: str, default: float, low: float, high: float, meaning: str) -> Parameter:
    """Return an estimated length [m]."""
    return Parameter(name, Measure.LENGTH, default, low, high, meaning)


def tool_parameters(mass: float, open_time: float, close_time: float) -> tuple[Parameter, ...]:
    """Return mass, centre of mass, TCP and times of a gripper, all estimated.

    Args:
        mass: default [kg].
        open_time: default [s].
        close_time: default [s].
    """
    tcp = "Distance of the TCP; with it the length of the housing follows, without it the TCP does."
    com = "Distance of the centre of mass from the mechanical interface; without it that of the shapes."
    return (
        Parameter("mass", Measure.MASS, mass, 0.01, 100.0, "Mass of the whole."),
        Parameter("com", Measure.LENGTH, None, 0.0, 1.0, com),
        Parameter(TCP, Measure.LENGTH, None, 0.06, 1.0, tcp),
        Parameter("open_time", Measure.TIME, open_time, 0.0, 10.0, "Time that opening takes."),
        Parameter("close_time", Measure.TIME, close_time, 0.0, 10.0, "Time that closing takes."),
    )
