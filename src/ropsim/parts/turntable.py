"""Turntables: a plate that turns on a drum with a foot plate."""

from ropsim.model import Material
from ropsim.parts.elements import BODY, DARK, STEEL, block, length_of, upright
from ropsim.parts.part_kind import LibraryPart, PartKind, Use, Values

_FOOT = 0.02  # [m], thickness of the foot plate

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
    mark = block(
        (0.02, 0.04, 0.6 * thick), (radius, 0.0, -0.5 * thick), "#e2702b"
    )  # stands out at the edge, below the upper side
    plate = upright(radius, -thick, 0.0, STEEL, Material.STEEL)
    base = (
        upright(0.9 * drum, -thick - bearing, -thick, DARK),
        upright(drum, -height + _FOOT, -thick - bearing, BODY),
        block((2.2 * drum, 2.2 * drum, _FOOT), (0.0, 0.0, -height + _FOOT / 2.0), DARK),
    )
    return LibraryPart(base, (plate, mark), colour=STEEL)


TURNTABLE = PartKind(
    "turntable",
    "Turntable",
    Use.TURNTABLE,
    "In the middle of the plate, on its upper side; it turns about z. The floor is `height` below.",
    _PARAMETERS,
    _make,
    at_most=(("drum_diameter", "diameter"),),
)
