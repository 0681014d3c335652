"""Shapes of the palletizer: slats and rods around its link lengths, by eye."""

from ropsim.model import DARK_GREY, STEEL_GREY, Box, Prism, Revolve, Shape, around, rod
from ropsim.spatial import Pose, translation

REACH, HEIGHT = 0.25, 0.82  # place of axes 2 and 3 ahead of axis 1 and above the floor [m]
LOWER_ARM = 1.15  # axis 2 to the elbow
FOREARM = 1.35  # elbow to the wrist
CRANK = 0.4  # axis 3 to its rod, and elbow to the rear end of the forearm
PIN = (-0.18, 0.2)  # of the links that keep level, from their joints, ahead and up
WRIST, FLANGE = 0.22, 0.3  # axis 4 ahead of the wrist, interface below it

_BODY, _SHADE, _ACCENT = "#e9a23b", "#cf8d2e", "#5b6770"


def base() -> tuple[Shape, ...]:
    """Return the foot, in the base frame."""
    ring = Revolve(((0.0, 0.0), (0.38, 0.0), (0.38, 0.06), (0.3, 0.1), (0.3, 0.3), (0.0, 0.3)))
    return (
        Shape(ring, Pose(), DARK_GREY),
        Shape(Box((0.9, 0.9, 0.03)), translation(0.0, 0.0, 0.015), _ACCENT),
    )


def links() -> tuple[tuple[Shape, ...], ...]:
    """Return the shapes of the ten bodies, each in the frame of its joint."""
    return (
        _column(),
        (_slat(0.0, LOWER_ARM, 0.13, 0.09, -0.06, 0.12, _BODY), _hub(0.13, _SHADE)),
        (_slat(-CRANK, 0.0, 0.06, 0.1, 0.12, 0.07, _ACCENT),),
        (
            _slat(-CRANK, 0.0, 0.06, 0.1, -0.05, 0.1, _BODY),
            _slat(0.0, FOREARM, 0.1, 0.07, -0.05, 0.1, _BODY),
        ),
        (_bar(LOWER_ARM, 0.155, 0.025),),
        (
            Shape(Box((0.34, 0.1, 0.16)), translation(0.1, 0.03, 0.0), _SHADE),
            rod((0.0, 0.0, -0.1), (*PIN, -0.1), 0.03, None, _ACCENT),
            rod((WRIST, 0.0, 0.0), (WRIST, -0.08, 0.0), 0.09, None, DARK_GREY),
        ),
        (
            rod((0.0, 0.0, -0.125), (0.0, 0.0, -0.05), 0.05, None, DARK_GREY),
            rod((0.0, 0.0, -0.11), (*PIN, -0.11), 0.035, None, _ACCENT),
            rod((0.0, 0.0, -0.11), (0.08, 0.18, -0.11), 0.03, None, _ACCENT),
            rod((*PIN, -0.11), (0.08, 0.18, -0.11), 0.03, None, _ACCENT),
        ),
        (_bar(LOWER_ARM, -0.13, 0.02),),
        (_bar(FOREARM, -0.13, 0.02),),
        (
            rod((0.0, 0.0, 0.08), (0.0, 0.0, FLANGE - 0.03), 0.06, None, STEEL_GREY),
            rod((0.0, 0.0, FLANGE - 0.03), (0.0, 0.0, FLANGE), 0.1, None, DARK_GREY),
        ),
    )


def _column() -> tuple[Shape, ...]:
    return (
        rod((0.0, 0.0, 0.3), (0.0, 0.0, 0.42), 0.33, 0.3, _BODY),
        Shape(Box((0.55, 0.16, 0.62)), translation(0.12, -0.2, 0.7), _BODY),
        Shape(Box((0.55, 0.1, 0.62)), translation(0.12, 0.22, 0.7), _BODY),
        rod((REACH, -0.3, HEIGHT), (REACH, 0.28, HEIGHT), 0.1, None, DARK_GREY),
        rod((REACH, 0.13, HEIGHT), (REACH + PIN[0], 0.13, HEIGHT + PIN[1]), 0.035, None, _ACCENT),
    )


def _slat(
    start: float, end: float, first: float, last: float, low: float, depth: float, colour: str
) -> Shape:
    """Return a slat along x with round ends, beginning at `low` along the joint."""
    return Shape(
        Prism(around(((start, 0.0, first), (end, 0.0, last))), depth), translation(0.0, 0.0, low), colour
    )


def _hub(radius: float, colour: str) -> Shape:
    return rod((0.0, 0.0, -0.1), (0.0, 0.0, 0.1), radius, None, colour)


def _bar(length: float, beside: float, radius: float) -> Shape:
    """Return a link that turns on pins at both ends, `beside` the plane of the arm."""
    bar = Prism(around(((0.0, 0.0, 1.5 * radius), (length, 0.0, 1.5 * radius))), radius)
    return Shape(bar, translation(0.0, 0.0, beside - radius / 2.0), STEEL_GREY)
