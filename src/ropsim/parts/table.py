"""Tables: a top on a frame of profiles with adjustable feet."""

from itertools import product

from ropsim.model import DARK_GREY, STEEL_GREY, Material
from ropsim.parts.elements import LIGHT_TOP, block, length_of, upright
from ropsim.parts.part_kind import LibraryPart, PartKind, Use, Values

_FOOT = 0.03  # [m], height of an adjustable foot

_PARAMETERS = (
    length_of("length", 1.2, 0.3, 6.0, "Length of the top, along x."),
    length_of("width", 0.8, 0.3, 3.0, "Width of the top, along y."),
    length_of("height", 0.85, 0.25, 2.0, "Height of the top above the floor."),
    length_of("top_thickness", 0.04, 0.005, 0.1, "Thickness of the top."),
    length_of("profile", 0.045, 0.02, 0.1, "Edge of the profiles."),
)


def _make(values: Values) -> LibraryPart:
    """Return a table: its frame in the middle on the floor."""
    length, width, height = values["length"], values["width"], values["height"]
    thick, edge = values["top_thickness"], values["profile"]
    under = height - thick
    inset = 0.02
    x, y = length / 2.0 - inset - edge / 2.0, width / 2.0 - inset - edge / 2.0
    top = block((length, width, thick), (0.0, 0.0, height - thick / 2.0), LIGHT_TOP)
    corners = list(product((-x, x), (-y, y)))
    feet = (upright(0.45 * edge, 0.0, _FOOT, DARK_GREY, Material.RUBBER, a, b) for a, b in corners)
    posts = (
        block((edge, edge, under - _FOOT), (a, b, (under + _FOOT) / 2.0), STEEL_GREY, Material.STEEL)
        for a, b in corners
    )
    braces = (
        block(size, (a, b, z), STEEL_GREY, Material.STEEL)
        for z in (under - edge / 2.0, _FOOT + 0.2 * (under - _FOOT))
        for size, a, b in (
            ((2.0 * x - edge, edge, edge), 0.0, -y),
            ((2.0 * x - edge, edge, edge), 0.0, y),
            ((edge, 2.0 * y - edge, edge), -x, 0.0),
            ((edge, 2.0 * y - edge, edge), x, 0.0),
        )
    )
    return LibraryPart((top, *posts, *braces, *feet), colour=LIGHT_TOP)


TABLE = PartKind(
    "table",
    "Table",
    Use.OBJECT,
    "In the middle on the floor; the top is `height` above.",
    _PARAMETERS,
    _make,
)
