"""Belt conveyors: a belt around two end rollers, side frames, and supports down to the floor."""

from math import ceil

from ropsim.model import Cylinder, Material, Prism, Shape, around
from ropsim.parts.elements import ALONG_Y, BODY, DARK, RUBBER, STEEL, block, length_of
from ropsim.parts.part_kind import LibraryPart, PartKind, Use, Values
from ropsim.spatial import Pose, frozen

_BELOW = 0.004  # [m], from the belt down to the upper edge of the frames
_FRAME = 0.03  # [m], thickness of a side frame
_GAP = 0.005  # [m], from the belt to a frame
_FOOT = 0.01  # [m], height of a foot plate

_PARAMETERS = (
    length_of("length", 2.0, 0.2, 12.0, "Length of the belt."),
    length_of("width", 0.4, 0.05, 2.0, "Width of the belt; usual are 150 to 1000 mm."),
    length_of("height", 0.8, 0.2, 2.0, "Height of the belt above the floor; usual are 700 to 950 mm."),
    length_of("roller_diameter", 0.05, 0.01, 0.15, "Diameter of the end rollers."),
    length_of("frame_height", 0.08, 0.02, 0.15, "Height of the side frames."),
    length_of("profile", 0.045, 0.02, 0.1, "Edge of the profiles of the supports."),
    length_of("support_distance", 1.5, 1.0, 6.0, "Greatest distance between two supports."),
)


def _make(values: Values) -> LibraryPart:
    """Return a conveyor in its base frame: x along the belt from its start, z = 0 on the belt."""
    length, width, high = values["length"], values["width"], values["frame_height"]
    radius = values["roller_diameter"] / 2.0
    inner = width / 2.0 + _GAP
    belt = Shape(
        # drawn out from y = -width/2; x of the outline along x, its y along -z of the base
        Prism(around(((radius, radius, radius), (length - radius, radius, radius))), width),
        Pose(frozen([0.0, -width / 2.0, 0.0]), ALONG_Y),
        RUBBER,
        material=Material.RUBBER,
    )
    frames = tuple(
        block(
            (length - 2.0 * radius, _FRAME, high),
            (length / 2.0, side * (inner + _FRAME / 2.0), -_BELOW - high / 2.0),
            STEEL,
            Material.STEEL,
        )
        for side in (-1.0, 1.0)
    )
    rollers = tuple(
        Shape(
            Cylinder(0.7 * radius, width + 2.0 * (_GAP + _FRAME)),
            Pose(frozen([x, 0.0, -radius]), ALONG_Y),
            STEEL,
            material=Material.STEEL,
        )
        for x in (radius, length - radius)
    )
    return LibraryPart(
        (belt, *frames, *rollers, *_motor(values, inner), *_supports(values, inner)), colour=RUBBER
    )


def _motor(values: Values, inner: float) -> tuple[Shape, ...]:
    """Return gear and motor at the side of the last roller."""
    radius = values["roller_diameter"] / 2.0
    size = 1.6 * values["roller_diameter"]
    x, y = values["length"] - max(radius, size / 2.0), inner + _FRAME
    z = -_BELOW - size / 2.0
    motor = Cylinder(0.4 * size, 1.5 * size)
    return (
        block((size, 0.6 * size, size), (x, y + 0.3 * size, z), DARK),
        Shape(motor, Pose(frozen([x, y + 1.35 * size, z]), ALONG_Y), BODY),
    )


def _supports(values: Values, inner: float) -> tuple[Shape, ...]:
    """Return pairs of posts with a cross bar and a foot plate each, from the frames to the floor."""
    length, edge, floor = values["length"], values["profile"], -values["height"]
    top = -_BELOW - values["frame_height"]
    first = min(0.15 * length, 0.3)
    count = 1 + ceil((length - 2.0 * first) / values["support_distance"] - 1e-9)
    step = (length - 2.0 * first) / (count - 1)
    post, y = top - floor, inner + _FRAME / 2.0
    found: list[Shape] = []
    for number in range(count):
        x = first + number * step
        middle = floor + post / 2.0
        found += [
            block((edge, edge, post), (x, side * y, middle), STEEL, Material.STEEL) for side in (-1.0, 1.0)
        ]
        found.append(block((edge, 2.0 * y, edge), (x, 0.0, floor + 0.45 * post), STEEL, Material.STEEL))
        found.append(block((2.0 * edge, 2.0 * y + 2.0 * edge, _FOOT), (x, 0.0, floor + _FOOT / 2.0), DARK))
    return tuple(found)


BELT_CONVEYOR = PartKind(
    "belt_conveyor",
    "Belt conveyor",
    Use.CONVEYOR,
    "Amid the start of the belt, on its upper side; x along the belt. The floor is `height` below.",
    _PARAMETERS,
    _make,
)
