"""Three joints of which one slides bring a point to a place: the common part of their two classes."""

from typing import Protocol

import numpy as np

from ropsim.spatial import Array

EDGE = 1e-10
"""A cosine or a squared length [m²] so far beyond its bound is rounding at the edge of reach."""
ON_AXIS = 1e-10
"""A point this near to an axis [m] lies on it."""


class Places(Protocol):
    """A point on the third of three joints, of which one slides."""

    @property
    def words(self) -> tuple[tuple[str, ...], ...]:
        """Return the words of each way to a place."""

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the subject of each of these words."""

    def motions(self, p: Array, near: Array) -> Array:
        """Return all ways to places, shape (k, ways, 3) [rad | m], NaN where absent.

        Args:
            p: places in J [m], shape (k, 3).
            near: motions that stay where a place leaves them free, shape (3,).
        """

    def way(self, m: Array) -> int:
        """Return the number of the way of motions (3,)."""

    def margin(self, m: Array) -> float:
        """Return how far motions (3,) are from where ways meet [rad, m]."""

    def distances(self, p: Array) -> tuple[str, float, float, float]:
        """Return an axis, how far a place (3,) is from it, and between which distances it may be [m]."""


def rotated(axis: Array, angles: Array | float, vectors: Array) -> Array:
    """Return vectors (..., 3) turned about a unit vector by angles (...) [rad] (Rodrigues)."""
    c, s = np.cos(angles)[..., np.newaxis], np.sin(angles)[..., np.newaxis]
    level = (vectors @ axis)[..., np.newaxis] * axis
    return np.asarray(c * (vectors - level) + s * np.cross(axis, vectors) + level)


def clipped(values: Array, low: float, high: float) -> Array:
    """Return values between bounds, rounding beyond them mended; NaN for those farther off."""
    inside = (values >= low - EDGE) & (values <= high + EDGE)
    return np.where(inside, np.clip(values, low, high), np.nan)


def all_present(rows: Array) -> Array:
    """Return rows (..., n) with NaN throughout where one of their numbers is NaN."""
    return np.where(np.isnan(rows).any(axis=-1, keepdims=True), np.nan, rows)
