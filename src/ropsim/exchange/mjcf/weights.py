"""Weights of homogeneous solids, as MuJoCo takes them where a body says none of its own."""

from collections.abc import Callable
from math import pi

import numpy as np

from ropsim.exchange.files.values import number_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER
from ropsim.exchange.losses.notes import Notes
from ropsim.model import Payload, moved
from ropsim.spatial import Pose

_DENSITY = 1000.0  # kg/m³, of MuJoCo
Unit = tuple[float, tuple[float, float, float]]
"""Volume [m³], and principal moments over the mass [m²]."""


def weight_of(geom: Element, kind: str, size: tuple[float, ...], X: Pose, notes: Notes) -> Payload:
    """Return the weight of a homogeneous solid, in the frame of its body.

    Args:
        geom: with `mass`, or `density`, or neither.
        kind: of the solid.
        size: half edges, or radius and half length [m].
        X: of the solid in its body.
        notes: for a negative mass.
    """
    volume, moments = _UNIT[kind](*size)
    if "mass" in geom.attributes:
        mass = number_of(geom, "mass", notes)
    else:
        mass = volume * number_of(geom, "density", notes, _DENSITY)
    if mass < 0.0:
        notes.add(BAD_NUMBER, geom.span, f"a geometry has a mass of {mass:g} kg", "check the sign")
        return Payload()
    return moved(Payload(mass, np.zeros(3), np.diag(mass * np.array(moments))), X)


def _box(x: float, y: float, z: float) -> Unit:
    return 8.0 * x * y * z, ((y * y + z * z) / 3.0, (x * x + z * z) / 3.0, (x * x + y * y) / 3.0)


def _ellipsoid(x: float, y: float, z: float) -> Unit:
    return 4.0 / 3.0 * pi * x * y * z, ((y * y + z * z) / 5.0, (x * x + z * z) / 5.0, (x * x + y * y) / 5.0)


def _sphere(r: float) -> Unit:
    return _ellipsoid(r, r, r)


def _cylinder(r: float, h: float) -> Unit:
    across = r * r / 4.0 + h * h / 3.0
    return 2.0 * pi * r * r * h, (across, across, r * r / 2.0)


def _capsule(r: float, h: float) -> Unit:
    """Return a cylinder between two half spheres, each with its centre of mass 3/8 r behind its flat side."""
    tube, (across, _, along) = _cylinder(r, h)
    ball = 4.0 / 3.0 * pi * r**3
    caps = 2.0 / 5.0 * r * r + h * h + 3.0 / 4.0 * h * r
    whole = tube + ball
    side = (tube * across + ball * caps) / whole
    return whole, (side, side, (tube * along + ball * 2.0 / 5.0 * r * r) / whole)


_UNIT: dict[str, Callable[..., Unit]] = {
    "box": _box,
    "ellipsoid": _ellipsoid,
    "sphere": _sphere,
    "cylinder": _cylinder,
    "capsule": _capsule,
}
