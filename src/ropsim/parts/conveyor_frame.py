"""Frames of conveyors: two side frames, and supports down to the floor."""

from math import ceil

from ropsim.model import DARK_GREY, STEEL_GREY, Material, Shape
from ropsim.parts.elements import block, length_of
from ropsim.parts.part_kind import Values

BELOW = 0.004
"""From the upper side of the conveyor down to the upper edge of the frames [m]."""
FRAME = 0.03
"""Thickness of a side frame [m]."""
_FOOT = 0.01  # [m], height of a foot plate

FRAME_PARAMETERS = (
    length_of("frame_height", 0.08, 0.02, 0.15, "Height of the side frames."),
    length_of("profile", 0.045, 0.02, 0.1, "Edge of the profiles of the supports."),
    length_of("support_distance", 1.5, 1.0, 6.0, "Greatest distance between two supports."),
)
"""Parameters of frames and supports."""


def side_frames(values: Values, inner: float, inset: float) -> tuple[Shape, ...]:
    """Return the two side frames.

    Args:
        values: of the parameters of the conveyor.
        inner: distance of a frame from the middle of the conveyor [m].
        inset: distance of their ends from those of the conveyor [m].
    """
    length, high = values["length"], values["frame_height"]
    return tuple(
        block(
            (length - 2.0 * inset, FRAME, high),
            (length / 2.0, side * (inner + FRAME / 2.0), -BELOW - high / 2.0),
            STEEL_GREY,
            Material.STEEL,
        )
        for side in (-1.0, 1.0)
    )


def supports(values: Values, inner: float) -> tuple[Shape, ...]:
    """Return pairs of posts with a cross bar and a foot plate each, from the frames to the floor.

    Args:
        values: of the parameters of the conveyor.
        inner: distance of a frame from the middle of the conveyor [m].
    """
    length, edge, floor = values["length"], values["profile"], -values["height"]
    top = -BELOW - values["frame_height"]
    first = min(0.15 * length, 0.3)
    count = 1 + ceil((length - 2.0 * first) / values["support_distance"] - 1e-9)
    step = (length - 2.0 * first) / (count - 1)
    post, y = top - floor, inner + FRAME / 2.0
    found: list[Shape] = []
    for number in range(count):
        x = first + number * step
        middle = floor + post / 2.0
        found += [
            block((edge, edge, post), (x, side * y, middle), STEEL_GREY, Material.STEEL)
            for side in (-1.0, 1.0)
        ]
        found.append(block((edge, 2.0 * y, edge), (x, 0.0, floor + 0.45 * post), STEEL_GREY, Material.STEEL))
        found.append(
            block((2.0 * edge, 2.0 * y + 2.0 * edge, _FOOT), (x, 0.0, floor + _FOOT / 2.0), DARK_GREY)
        )
    return tuple(found)
