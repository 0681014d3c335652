"""Directions in which a tool may point, spread evenly over the sphere, and orientations with them."""

import numpy as np

from ropsim.spatial import Array

GOLDEN = 0.5 * (1.0 + 5.0**0.5)


def sphere(count: int) -> Array:
    """Return directions on a Fibonacci lattice, each for the same area, shape (count, 3).

    Point k has height 1 - (2k + 1)/count and azimuth 2π·k/φ (Swinbank & Purser 2006).
    """
    k = np.arange(count)
    z = 1.0 - (2.0 * k + 1.0) / count
    azimuth, radius = 2.0 * np.pi * k / GOLDEN, np.sqrt(1.0 - z * z)
    return np.column_stack((radius * np.cos(azimuth), radius * np.sin(azimuth), z))


def orientations(directions: Array, rolls: int) -> Array:
    """Return rotations whose z axis is a direction, turned about it by even steps, (k·rolls, 3, 3)."""
    made = []
    for z in directions:
        other = np.array([1.0, 0.0, 0.0]) if abs(z[0]) < 0.7 else np.array([0.0, 1.0, 0.0])
        x = other - (other @ z) * z
        x /= np.linalg.norm(x)
        y = np.cross(z, x)
        for angle in np.arange(rolls) * 2.0 * np.pi / rolls:
            first = np.cos(angle) * x + np.sin(angle) * y
            made.append(np.column_stack((first, np.cross(z, first), z)))
    return np.array(made)
