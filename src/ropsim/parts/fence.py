"""Fences: posts on foot plates, and panels of wire mesh between them."""

from collections.abc import Iterator
from math import ceil

from ropsim.model import DARK_GREY, Box, Material, OriginKind, Point3, Polyline, Shape
from ropsim.parts.elements import block, length_of
from ropsim.parts.part_kind import LibraryPart, Measure, Parameter, PartKind, Use, Values
from ropsim.spatial import translation

_YELLOW = "#d1a82b"
_FOOT = 0.01  # [m], thickness of a foot plate
_WIRE = 0.004  # [m], thickness of the mesh
_SOURCE = "EN ISO 13857 and 14120, second hand"

_PARAMETERS = (
    length_of("length", 3.0, 0.3, 12.0, "Length of the fence."),
    Parameter(
        "height",
        Measure.LENGTH,
        2.0,
        0.3,
        4.0,
        "Height above the floor; at least 1400 mm, and nobody reaches over 2700 mm.",
        OriginKind.ESTIMATED,
        f"within the bounds of {_SOURCE}",
    ),
    Parameter(
        "floor_gap",
        Measure.LENGTH,
        0.15,
        0.0,
        0.25,
        "Free height below the panels; at most 180 mm.",
        OriginKind.ESTIMATED,
        f"within the bound of {_SOURCE}",
    ),
    length_of("panel_width", 1.0, 0.5, 3.0, "Greatest distance from post to post; usual are 200 to 1500 mm."),
    length_of("post", 0.06, 0.02, 0.15, "Edge of the posts."),
    length_of("mesh", 0.04, 0.02, 0.2, "Distance of the wires of the mesh."),
)


def _make(values: Values) -> LibraryPart:
    """Return a fence along x; the panels count as solid, the wires are drawn as lines."""
    length, height, gap = values["length"], values["height"], values["floor_gap"]
    edge, mesh = values["post"], values["mesh"]
    count = max(1, ceil(length / values["panel_width"] - 1e-9))
    posts: list[Shape] = []
    for number in range(count + 1):
        x = edge / 2.0 + number * (length - edge) / count
        posts.append(block((edge, edge, height), (x, 0.0, height / 2.0), _YELLOW))
        posts.append(block((2.0 * edge, 2.0 * edge, _FOOT), (x, 0.0, _FOOT / 2.0), DARK_GREY))
    top = height - 0.02
    middle = translation(length / 2.0, 0.0, (gap + top) / 2.0)
    panel = Shape(Box((length - 2.0 * edge, _WIRE, top - gap)), middle, DARK_GREY, 0.12, Material.STEEL)
    rails = (
        block((length - 2.0 * edge, 0.4 * edge, 0.02), (length / 2.0, 0.0, z), DARK_GREY)
        for z in (gap + 0.01, top - 0.01)
    )
    upright = Polyline(tuple(_snake(edge, length - edge, mesh, gap, top, across=0)))
    level = Polyline(tuple(_snake(gap, top, mesh, edge, length - edge, across=2)))
    wires = (Shape(lines, colour=DARK_GREY, material=Material.STEEL) for lines in (upright, level))
    return LibraryPart((*posts, *rails, panel, *wires), colour=_YELLOW)


def _snake(first: float, last: float, step: float, low: float, high: float, across: int) -> Iterator[Point3]:
    """Yield the points of one line through all wires of a direction.

    Args:
        first: place of the first wire, along the axis `across` [m].
        last: place of the last one [m].
        step: distance of the wires at most [m].
        low: lower end of the wires along the other axis, z or x [m].
        high: their upper end [m].
        across: 0 for upright wires, 2 for level ones.
    """
    count = max(1, ceil((last - first) / step - 1e-9))
    for number in range(count + 1):
        place = first + number * (last - first) / count
        ends = (low, high) if number % 2 == 0 else (high, low)
        for end in ends:
            yield (place, 0.0, end) if across == 0 else (end, 0.0, place)


FENCE = PartKind(
    "fence",
    "Fence",
    Use.OBJECT,
    "At the start of the fence on the floor; it goes along x.",
    _PARAMETERS,
    _make,
)
