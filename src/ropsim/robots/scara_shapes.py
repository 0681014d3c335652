"""Shapes of the SCARA arm: primitives around its link lengths, by eye."""

import numpy as np

from ropsim.model import DARK_GREY, STEEL_GREY, Box, Prism, Revolve, Shape, around, rod
from ropsim.spatial import Pose

_WHITE, _SHADE, _ACCENT = "#e6e8ea", "#cfd4d8", "#e2702b"
_SHOULDER = 0.387  # height of the arm [m]
_INNER, _OUTER = 0.325, 0.275  # lengths of its two links


def base() -> tuple[Shape, ...]:
    """Return foot and column, in the base frame."""
    column = Revolve(((0.0, 0.0), (0.1, 0.0), (0.1, 0.02), (0.085, 0.05), (0.085, 0.3), (0.0, 0.3)))
    return (
        Shape(Box((0.26, 0.22, 0.02)), Pose(np.array([-0.03, 0.0, 0.01])), DARK_GREY),
        Shape(column, Pose(), _WHITE),
        Shape(Box((0.1, 0.14, 0.22)), Pose(np.array([-0.09, 0.0, 0.13])), DARK_GREY),
    )


def links() -> tuple[tuple[Shape, ...], ...]:
    """Return the shapes of links 1 to 4, each in the frame of its joint."""
    inner = Prism(around(((0.0, 0.0, 0.085), (_INNER, 0.0, 0.07))), 0.07)
    outer = Prism(around(((0.0, 0.0, 0.07), (_OUTER, 0.0, 0.055))), 0.08)
    return (
        (
            Shape(inner, _up(0.302), _WHITE),
            rod((0.0, 0.0, 0.372), (0.0, 0.0, 0.382), 0.06, None, _ACCENT),
            rod((_INNER, 0.0, 0.372), (_INNER, 0.0, _SHOULDER), 0.05, None, DARK_GREY),
        ),
        (
            Shape(outer, _up(0.0), _WHITE),
            Shape(Box((0.16, 0.1, 0.12)), Pose(np.array([0.1, 0.0, 0.14])), _SHADE),
            rod((_OUTER, 0.0, 0.08), (_OUTER, 0.0, 0.27), 0.03, None, DARK_GREY),
        ),
        (rod((0.0, 0.0, -0.24), (0.0, 0.0, -0.012), 0.025, None, STEEL_GREY),),
        (rod((0.0, 0.0, -0.012), (0.0, 0.0, 0.0), 0.03, None, DARK_GREY),),
    )


def _up(z: float) -> Pose:
    return Pose(np.array([0.0, 0.0, z]))
