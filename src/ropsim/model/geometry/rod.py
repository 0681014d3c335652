"""Rods: cylinders and frustums from one point to another."""

from math import hypot

import numpy as np
import numpy.typing as npt

from ropsim.model.geometry.elements import LIGHT_GREY, Cylinder, Material, Shape
from ropsim.spatial import Array, Pose


def rod(
    start: npt.ArrayLike,
    end: npt.ArrayLike,
    radius: float,
    top: float | None = None,
    colour: str = LIGHT_GREY,
    material: Material = Material.PAINT,
) -> Shape:
    """Return a round rod between two different points.

    Args:
        start: centre of its first face in the frame of the body [m], shape (3,).
        end: centre of the other face [m], shape (3,).
        radius: at the start [m].
        top: radius at the end [m]; None for the same.
        colour: `#rrggbb`.
        material: how its surface takes the light.
    """
    first, last = np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64)
    length = hypot(*(last - first).tolist())  # unlike a norm of arrays the same bits on every machine
    pose = Pose((first + last) / 2.0, z_turned_to((last - first) / length))
    return Shape(Cylinder(radius, length, top), pose, colour, material=material)


def z_turned_to(direction: Array) -> Array:
    """Return the shortest rotation (w, x, y, z) that turns z into a unit vector, shape (3,)."""
    x, y, z = direction.tolist()
    if z < -1.0 + 1e-12:
        return np.array([0.0, 1.0, 0.0, 0.0])  # straight down: half a turn about x, as about any other axis
    half = np.array([1.0 + z, -y, x, 0.0])
    return np.asarray(half / hypot(*half.tolist()))
