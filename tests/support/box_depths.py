"""How deep boxes are in each other, by the separating axis theorem (Gottschalk, Lin & Manocha 1996)."""

from typing import TypeAlias

import numpy as np

from ropsim.spatial import Array

PlacedBox: TypeAlias = tuple[Array, Array, Array]
"""Rotation, shape (k, 3, 3), centre, shape (k, 3) [m], and half edges, shape (3,) [m], at k rows."""


def overlap(one: PlacedBox, other: PlacedBox) -> Array:
    """Return how deep boxes are in each other by all 15 separating axes [m], shape (k,).

    It is not positive where they are apart.
    """
    (R_a, c_a, h_a), (R_b, c_b, h_b) = one, other
    crossed = np.cross(R_a.transpose(0, 2, 1)[:, :, None], R_b.transpose(0, 2, 1)[:, None]).reshape(-1, 9, 3)
    axes = np.concatenate([R_a.transpose(0, 2, 1), R_b.transpose(0, 2, 1), crossed], axis=1)
    lengths = np.linalg.norm(axes, axis=2)
    axes = axes / np.where(lengths > 1e-6, lengths, 1.0)[..., None]
    reach = np.abs(np.einsum("kai,kij->kaj", axes, R_a)) @ h_a
    reach += np.abs(np.einsum("kai,kij->kaj", axes, R_b)) @ h_b
    depth = reach - np.abs(np.einsum("kai,ki->ka", axes, c_b - c_a))
    return np.asarray(np.where(lengths > 1e-6, depth, np.inf).min(axis=1))
