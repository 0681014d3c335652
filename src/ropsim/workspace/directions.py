"""Directions of a tool, and azimuths about the first axis."""

import numpy as np

from ropsim.spatial import Array
from ropsim.workspace.ranges import TURN

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


ROUNDING = 12
"""Digits of a share that are kept: a sum of widths is a whole turn except for the last ones."""


def azimuth_shares(first: Array, extent: float) -> Array:
    """Return the reached azimuths for a first axis with limits, from its coordinates at azimuth 0.

    From a place the axis lets through azimuths as wide as its range, so that the azimuths of a direction
    begin at its coordinates: each lasts over the range, or until the next one begins. Where they begin and
    end is exact.

    Args:
        first: places of the axis by which a direction is reached [rad], NaN for none, shape (k, d, m).
        extent: of the range of the axis [rad], less than a turn.

    Returns:
        The share of the d directions, the mean over the azimuths with any; the share of azimuths of the turn
        with all directions, and with half of them or more; shape (k, 3).
    """
    k, d = first.shape[:2]
    begins = np.sort(np.mod(first, TURN), axis=2)  # NaN come last
    there = np.isfinite(begins)
    following = np.concatenate((begins[:, :, 1:], np.full((k, d, 1), np.nan)), axis=2)
    following = np.where(np.isfinite(following), following, begins[:, :, :1] + TURN)
    ends = begins + np.minimum(following - begins, extent)
    over = ends >= TURN  # begins anew at 0
    times = np.concatenate((np.where(there, begins, 0.0), np.where(there, ends - TURN * over, 0.0)), axis=2)
    steps = np.concatenate((np.where(there, 1, 0), np.where(there, -1, 0)), axis=2).reshape(k, -1)
    times = times.reshape(k, -1)
    order = np.argsort(times, axis=1, kind="stable")
    times = np.concatenate((np.take_along_axis(times, order, 1), np.full((k, 1), TURN)), axis=1)
    before = over.sum(axis=(1, 2))[:, np.newaxis]
    changed = np.cumsum(np.take_along_axis(steps, order, 1), axis=1)
    count = np.concatenate((before, before + changed), axis=1)
    width = np.diff(times, axis=1, prepend=0.0) / TURN
    reached = (width * (count > 0)).sum(axis=1)
    share = (width * count).sum(axis=1) / (d * np.where(reached > 0.0, reached, 1.0))
    all_of_them, half = ((width * one).sum(axis=1) for one in (count == d, 2 * count >= d))
    return np.stack((np.round(share, ROUNDING), all_of_them, half), axis=1)
