"""Shapes of the PUMA 560: primitives around its published dimensions, by eye where none are published.

Each list stands in the frame of its joint (see `Link`). The axis of joint 1 is the middle of the trunk, its
frame lies at the floor. Link 2 lies outside the shoulder, along x of frame 2, about 0.23 m from the trunk's
axis; link 3 inside it, along y of frame 3, in the plane of the wrist.
"""

from math import sqrt

import numpy as np

from ropsim.model import DARK_GREY, STEEL_GREY, Box, Material, Prism, Revolve, Shape, Sphere, around, rod
from ropsim.spatial import Pose, translation

_WHITE = "#e6e8ea"
_SHADE = "#cfd4d8"
_ACCENT = "#e2702b"

_SHOULDER = 0.67183  # height of axis 2 [m]
_UPPER_ARM = 0.4318  # axis 2 to axis 3
_OFFSET = 0.15005  # of the forearm's middle from the trunk's axis, along axis 2
_ELBOW = 0.0203  # of the forearm's axis from axis 3
_FOREARM = 0.4318  # axis 3 to the wrist centre
_FLANGE = 0.05625  # wrist centre to the face of the flange

_UPPER = (0.196, 0.276)  # sides of the upper arm along axis 2
_LOWER = (0.11, 0.19)  # sides of the forearm
_PLAIN = Pose()


def base() -> tuple[Shape, ...]:
    """Return foot and trunk, in the base frame."""
    foot = Revolve(
        ((0.0, 0.0), (0.175, 0.0), (0.18, 0.005), (0.18, 0.018), (0.172, 0.026), (0.108, 0.032), (0.1, 0.04))
    )
    trunk = Revolve(((0.1, 0.04), (0.09, 0.07), (0.085, 0.12), (0.085, 0.505), (0.09, 0.512)))
    collar = Revolve(((0.09, 0.512), (0.098, 0.516), (0.098, 0.53), (0.0, 0.53)))
    box = Box((0.09, 0.13, 0.11))  # connectors at the back of the foot
    return (
        Shape(foot, _PLAIN, DARK_GREY),
        Shape(trunk, _PLAIN, _WHITE),
        Shape(collar, _PLAIN, DARK_GREY),
        Shape(box, Pose(np.array([-0.105, 0.0, 0.085])), DARK_GREY),
    )


def links() -> tuple[tuple[Shape, ...], ...]:
    """Return the shapes of links 1 to 6, each in the frame of its joint."""
    return (_link1(), _link2(), _link3(), _link4(), _link5(), _link6())


def _link1() -> tuple[Shape, ...]:
    """The head of the trunk: it turns about z and carries the shoulder, a drum along -y."""
    neck = Revolve(((0.0, 0.53), (0.094, 0.53), (0.094, 0.545), (0.088, 0.56), (0.088, _SHOULDER)))
    return (
        Shape(neck, _PLAIN, _WHITE),
        rod((0.0, 0.105, _SHOULDER), (0.0, -0.1, _SHOULDER), 0.095, None, _WHITE),
        rod((0.0, 0.118, _SHOULDER), (0.0, 0.105, _SHOULDER), 0.082, 0.09, DARK_GREY),
        rod((0.0, -0.1, _SHOULDER), (0.0, -0.112, _SHOULDER), 0.088, None, DARK_GREY),
    )


def _link2() -> tuple[Shape, ...]:
    """The upper arm: a plate with rounded ends, its motors behind the shoulder, on a hub along axis 2."""
    low, high = _UPPER
    plate = Prism(around(((-0.09, 0.0, 0.092), (0.0, 0.0, 0.118), (_UPPER_ARM, 0.0, 0.076))), high - low)
    cover = Prism(around(((-0.06, 0.0, 0.066), (0.1, 0.0, 0.07), (0.33, 0.0, 0.05))), 0.008)
    return (
        rod((0.0, 0.0, 0.112), (0.0, 0.0, low), 0.08, None, _WHITE),
        Shape(plate, translation(0.0, 0.0, low), _WHITE),
        Shape(cover, translation(0.0, 0.0, high), _SHADE),
        rod((_UPPER_ARM, 0.0, high), (_UPPER_ARM, 0.0, high + 0.012), 0.052, 0.048, _ACCENT),
    )


def _link3() -> tuple[Shape, ...]:
    """The forearm: a plate that tapers towards the wrist, its motors behind the elbow."""
    low, high = _LOWER
    plate = Prism(around(((-0.005, -0.075, 0.062), (0.0, 0.0, 0.078), (_ELBOW, 0.265, 0.046))), high - low)
    cover = Prism(around(((0.0, -0.06, 0.042), (_ELBOW, 0.2, 0.032))), 0.007)
    return (
        rod((0.0, 0.0, high), (0.0, 0.0, _UPPER[0]), 0.066, None, DARK_GREY),
        Shape(plate, translation(0.0, 0.0, low), _WHITE),
        Shape(cover, translation(0.0, 0.0, low - 0.007), _SHADE),
        rod((_ELBOW, 0.29, _OFFSET), (_ELBOW, 0.325, _OFFSET), 0.043, 0.038, _WHITE),
        rod((_ELBOW, 0.325, _OFFSET), (_ELBOW, 0.333, _OFFSET), 0.04, None, _ACCENT),
    )


def _link4() -> tuple[Shape, ...]:
    """The first part of the wrist: a sleeve about axis 4 that ends in two cheeks on axis 5 (along -y)."""
    cheek = Prism(around(((0.0, 0.0, 0.034), (-0.034, -0.055, 0.0), (0.034, -0.055, 0.0))), 0.012)
    sleeve = Revolve(((0.0, -0.099), (0.037, -0.099), (0.037, -0.066), (0.043, -0.055), (0.0, -0.055)))
    upright = np.array([1.0, 1.0, 0.0, 0.0]) / sqrt(2.0)  # x stays, y becomes z of the frame, z becomes -y
    return (
        Shape(sleeve, translation(0.0, 0.0, _FOREARM), _WHITE),
        Shape(cheek, Pose(np.array([0.0, 0.044, _FOREARM]), upright), _WHITE),
        Shape(cheek, Pose(np.array([0.0, -0.032, _FOREARM]), upright), _WHITE),
        rod((0.0, 0.044, _FOREARM), (0.0, 0.05, _FOREARM), 0.022, 0.02, DARK_GREY),
        rod((0.0, -0.044, _FOREARM), (0.0, -0.05, _FOREARM), 0.022, 0.02, DARK_GREY),
    )


def _link5() -> tuple[Shape, ...]:
    """The middle of the wrist: a drum between the cheeks with a neck along y, which is axis 6."""
    return (
        rod((0.0, 0.0, -0.032), (0.0, 0.0, 0.032), 0.031, None, _SHADE),
        Shape(Sphere(0.033), _PLAIN, _SHADE),
        rod((0.0, 0.0, 0.0), (0.0, 0.04, 0.0), 0.027, 0.025, _SHADE),
    )


def _link6() -> tuple[Shape, ...]:
    """The flange, a disc across z."""
    return (
        rod((0.0, 0.0, 0.038), (0.0, 0.0, 0.044), 0.024, None, DARK_GREY),
        rod((0.0, 0.0, 0.044), (0.0, 0.0, _FLANGE), 0.0315, None, STEEL_GREY, Material.STEEL),
    )
