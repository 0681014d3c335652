"""Roller conveyors: rollers between two side frames, and supports down to the floor."""

from math import ceil

from ropsim.model import STEEL_GREY, Cylinder, Material, Shape
from ropsim.parts.conveyor_frame import FRAME, FRAME_PARAMETERS, side_frames, supports
from ropsim.parts.elements import length_of
from ropsim.parts.part_kind import LibraryPart, PartKind, UpperBound, Use, Values
from ropsim.spatial import ALONG_Y, translation

_PARAMETERS = (
    length_of("length", 2.0, 0.2, 12.0, "Length from the first edge of the frames to the last."),
    length_of("width", 0.4, 0.05, 2.0, "Length of the rollers between the frames."),
    length_of("height", 0.8, 0.2, 2.0, "Height of the upper side of the rollers above the floor."),
    length_of("roller_diameter", 0.05, 0.01, 0.1, "Diameter of the rollers; usual are 20 to 89 mm."),
    length_of(
        "pitch", 0.1, 0.075, 0.5, "Greatest distance from roller to roller; at least three carry a part."
    ),
    *FRAME_PARAMETERS,
)


def _make(values: Values) -> LibraryPart:
    """Return a conveyor in its base frame: x along it from its start, z = 0 on the rollers."""
    length, width, radius = values["length"], values["width"], values["roller_diameter"] / 2.0
    inner = width / 2.0
    way = length - 2.0 * radius
    count = 1 + ceil(way / values["pitch"] - 1e-9)
    rollers = tuple(
        Shape(
            Cylinder(radius, width + 2.0 * FRAME),
            translation(radius + number * way / (count - 1), 0.0, -radius) @ ALONG_Y,
            STEEL_GREY,
            material=Material.STEEL,
        )
        for number in range(count)
    )
    shapes = (*rollers, *side_frames(values, inner, 0.0), *supports(values, inner))
    return LibraryPart(shapes, colour=STEEL_GREY)


ROLLER_CONVEYOR = PartKind(
    "roller_conveyor",
    "Roller conveyor",
    Use.CONVEYOR,
    "Amid the start of the conveyor, on the rollers; x along it. The floor is `height` below.",
    _PARAMETERS,
    _make,
    at_most=(UpperBound("roller_diameter", "pitch"),),
)
