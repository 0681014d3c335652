"""Chain: straight moves one after the other, with their lengths, directions, turns and zones."""

import numpy as np
import numpy.typing as npt

from ropsim.motion.curves.path import FARTHEST
from ropsim.motion.curves.rotation_vector import logarithms
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.time_law.profile import ProfileError
from ropsim.spatial import Array, cross, quaternions_from_matrices, record

SHORTEST_MOVE = 1e-6
"""Least length of a move [m]."""
_ROUNDING = 1e-3
"""Share of it by which coordinates may be rounded."""
_ORTHOGONAL = 1e-6
"""Largest element by which R·Rᵀ of a rotation may differ from 1."""


@record
class Chain:
    """Points and the k straight moves between them; lengths in m, angles in rad.

    Attributes:
        points: shape (k + 1, 3).
        rotations: orientations of the tool, shape (k + 1, 3, 3).
        quaternions: the same as unit quaternions, each in the half next to the one before, shape (k + 1, 4).
        zones: of the points between moves, as programmed, shape (k - 1,).
        lengths: of the moves, shape (k,).
        directions: of the moves, shape (k, 3).
        turns: angles between the moves at the points between them, shape (k - 1,).
        turn_changes: changes of the turn of the tool by the length at these points [rad/m], shape (k - 1,).
        ends: lengths along the polyline up to the points, shape (k + 1,).
    """

    points: Array
    rotations: Array
    quaternions: Array
    zones: Array
    lengths: Array
    directions: Array
    turns: Array
    turn_changes: Array
    ends: Array

    @property
    def cut_zones(self) -> Array:
        """Return the zones, at most half of both moves next to them, shape (k - 1,)."""
        return np.minimum(self.zones, 0.5 * np.minimum(self.lengths[:-1], self.lengths[1:]))


def chain_of(points: Array, rotations: Array, zones: Array) -> Chain:
    """Return the chain of points, orientations and zones, arrays as for `compressed`.

    Raises:
        ProfileError: M540, where shapes do not fit, a number is not finite, a rotation is none, a zone is not
            above 0 or a move is shorter than `SHORTEST_MOVE`.
    """
    count = len(points)
    shapes = points.shape, rotations.shape, zones.shape
    if count < 2 or shapes != ((count, 3), (count, 3, 3), (count - 2,)):
        raise refused(f"shapes {shapes}", "(k + 1, 3), (k + 1, 3, 3) and (k - 1,) with k of 1 or more")
    if not (np.abs(points) <= FARTHEST).all():  # NaN is not either
        raise refused(
            "a coordinate is not finite or too large", f"those from {-FARTHEST:g} to {FARTHEST:g} m"
        )
    if not ((np.abs(rotations) <= 1.0 + _ORTHOGONAL).all() and _are_rotations(rotations)):
        raise refused("a matrix is no rotation", "orthonormal ones with the determinant 1")
    if not ((zones > 0.0) & (zones <= FARTHEST)).all():
        raise refused(f"a zone is {_first(zones, zones > 0.0):g} m", f"those above 0, up to {FARTHEST:g} m")
    steps = np.diff(points, axis=0)
    lengths = _norm(steps)
    long_enough = lengths >= SHORTEST_MOVE * (1.0 - _ROUNDING)
    if not long_enough.all():
        raise refused(f"a move is {_first(lengths, long_enough):g} m long", f"{SHORTEST_MOVE:g} m or more")
    directions = steps / lengths[:, None]
    sines = _norm(cross(directions[:-1], directions[1:]))
    cosines = np.einsum("ij,ij->i", directions[:-1], directions[1:])
    turned = logarithms(np.swapaxes(rotations[:-1], 1, 2) @ rotations[1:]) / lengths[:, None]
    return Chain(
        points,
        rotations,
        _continuous(quaternions_from_matrices(rotations)),
        zones,
        lengths,
        directions,
        np.arctan2(sines, cosines),
        _norm(np.diff(turned, axis=0)),  # both vectors are in the tool frame at the point between
        np.concatenate(([0.0], np.cumsum(lengths))),
    )


def _are_rotations(matrices: Array) -> bool:
    """Return whether finite matrices (m, 3, 3) are rotations."""
    errors = np.abs(matrices @ np.swapaxes(matrices, 1, 2) - np.eye(3)).max(axis=(1, 2))
    return bool((errors <= _ORTHOGONAL).all() and (np.linalg.det(matrices) > 0.0).all())


def _continuous(quaternions: Array) -> Array:
    """Return unit quaternions with the signs that bring each next to the one before."""
    signs = np.where(np.einsum("ij,ij->i", quaternions[:-1], quaternions[1:]) < 0.0, -1.0, 1.0)
    return quaternions * np.concatenate(([1.0], np.cumprod(signs)))[:, None]


def refused(found: str, allowed: str) -> ProfileError:
    """Return the error of a value, with the allowed values."""
    return ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, allowed are {allowed}"))


def _first(values: Array, good: npt.NDArray[np.bool_]) -> float:
    """Return the first value that is not good, or the largest one if all are."""
    return float(values[~good][0]) if not good.all() else float(values.max())


def _norm(vectors: Array) -> Array:
    return np.asarray(np.linalg.norm(vectors, axis=1))
