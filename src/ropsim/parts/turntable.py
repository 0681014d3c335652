"""Turntables: a plate that turns on a drum with a foot plate."""

from math import sqrt

from ropsim.model import DARK_GREY, STEEL_GREY, Material
from ropsim.parts.elements import HOUSING, block, length_of, upright
from ropsim.parts.part_kind import LibraryPart, PartKind, UpperBound, Use, Values

ORANGE = "#e2702b"
_FOOT = 0.02  # [m], thickness of the foot plate
_GROOVE = 0.01  # [m], by which the lower part of the plate stands back, but for the mark
_MARK = 0.02  # [m], length of the mark, and half its width
_UPPER = 0.6  # share of the upper part in the thickness of the plate

_PARAMETERS = (
    length_of("diameter", 0.8, 0.1, 4.0, "Diameter of the plate; usual are 400 to 1200 mm."),
    length_of("thickness", 0.03, 0.005, 0.09, "Thickness of the plate."),
    length_of("height", 0.4, 0.15, 2.0, "Height of the plate above the floor; usual are 200 to 450 mm."),
    length_of("drum_diameter", 0.4, 0.05, 4.0, "Diameter of the drum below the plate."),
)


def _make(values: Values) -> LibraryPart:
    """Return a turntable in its base frame, which is the frame of the plate at coordinate 0."""
    radius, thick, height = values["diameter"] / 2.0, values["thickness"], values["height"]
    drum = values["drum_diameter"] / 2.0
    bearing = 0.012
    rim, edge = radius - _GROOVE, -_UPPER * thick
    outer = sqrt(radius**2 - _MARK**2)  # of the mark, whose corners are at the edge of the plate
    mark = block((_MARK, 2.0 * _MARK, thick + edge), (outer - _MARK / 2.0, 0.0, (edge - thick) / 2.0), ORANGE)
    plate = (
        upright(radius, edge, 0.0, STEEL_GREY, Material.STEEL),
        upright(rim, -thick, edge, STEEL_GREY, Material.STEEL),
    )
    base = (
        upright(0.9 * drum, -thick - bearing, -thick, DARK_GREY),
        upright(drum, -height + _FOOT, -thick - bearing, HOUSING),
        block((2.2 * drum, 2.2 * drum, _FOOT), (0.0, 0.0, -height + _FOOT / 2.0), DARK_GREY),
    )
    return LibraryPart(base, (*plate, mark), colour=STEEL_GREY)


TURNTABLE = PartKind(
    "turntable",
    "Turntable",
    Use.TURNTABLE,
    "In the middle of the plate, on its upper side; it turns about z. The floor is `height` below.",
    _PARAMETERS,
    _make,
    at_most=(UpperBound("drum_diameter", "diameter"),),
)
