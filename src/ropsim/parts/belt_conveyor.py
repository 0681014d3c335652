"""Belt conveyors: a belt around two end rollers, side frames, and supports down to the floor."""

from ropsim.model import DARK_GREY, STEEL_GREY, Cylinder, Material, Prism, Shape, around
from ropsim.parts.conveyor_frame import BELOW, FRAME, FRAME_PARAMETERS, side_frames, supports
from ropsim.parts.elements import HOUSING, RUBBER, block, length_of
from ropsim.parts.part_kind import LibraryPart, PartKind, Use, Values
from ropsim.spatial import ALONG_Y, translation

_GAP = 0.005  # [m], from the belt to a frame

_PARAMETERS = (
    length_of("length", 2.0, 0.2, 12.0, "Length of the belt."),
    length_of("width", 0.4, 0.05, 2.0, "Width of the belt; usual are 150 to 1000 mm."),
    length_of("height", 0.8, 0.2, 2.0, "Height of the belt above the floor; usual are 700 to 950 mm."),
    length_of("roller_diameter", 0.05, 0.01, 0.15, "Diameter of the end rollers."),
    *FRAME_PARAMETERS,
)


def _make(values: Values) -> LibraryPart:
    """Return a conveyor in its base frame: x along the belt from its start, z = 0 on the belt."""
    length, width = values["length"], values["width"]
    radius = values["roller_diameter"] / 2.0
    inner = width / 2.0 + _GAP
    belt = Shape(
        # drawn out from y = -width/2; x of the outline along x, its y along -z of the base
        Prism(around(((radius, radius, radius), (length - radius, radius, radius))), width),
        translation(0.0, -width / 2.0, 0.0) @ ALONG_Y,
        RUBBER,
        material=Material.RUBBER,
    )
    rollers = tuple(
        Shape(
            Cylinder(0.7 * radius, width + 2.0 * (_GAP + FRAME)),
            translation(x, 0.0, -radius) @ ALONG_Y,
            STEEL_GREY,
            material=Material.STEEL,
        )
        for x in (radius, length - radius)
    )
    shapes = (
        belt,
        *side_frames(values, inner, radius),
        *rollers,
        *_motor(values, inner),
        *supports(values, inner),
    )
    return LibraryPart(shapes, colour=RUBBER)


def _motor(values: Values, inner: float) -> tuple[Shape, ...]:
    """Return gear and motor at the side of the last roller."""
    radius = values["roller_diameter"] / 2.0
    size = 1.6 * values["roller_diameter"]
    x, y = values["length"] - max(radius, size / 2.0), inner + FRAME
    z = -BELOW - size / 2.0
    motor = Cylinder(0.4 * size, 1.5 * size)
    return (
        block((size, 0.6 * size, size), (x, y + 0.3 * size, z), DARK_GREY),
        Shape(motor, translation(x, y + 1.35 * size, z) @ ALONG_Y, HOUSING),
    )


BELT_CONVEYOR = PartKind(
    "belt_conveyor",
    "Belt conveyor",
    Use.CONVEYOR,
    "Amid the start of the belt, on its upper side; x along the belt. The floor is `height` below.",
    _PARAMETERS,
    _make,
)
