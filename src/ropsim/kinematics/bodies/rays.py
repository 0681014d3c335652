"""Rays: how far it is along a line to the nearest of many blocks."""

import numpy as np

from ropsim.kinematics.bodies.blocks import Blocks
from ropsim.spatial import Array


def nearest_along(blocks: Blocks, origin: Array, direction: Array) -> float:
    """Return the distance along a ray to the nearest block [m]; infinite where it meets none.

    A box is the intersection of three pairs of planes: the ray is in it from the last one that it enters
    until the first one that it leaves (slabs, Kay & Kajiya 1986). An upright cylinder is the box along z cut
    by a round wall. A ray that begins in a block is at distance 0.

    Args:
        blocks: boxes and upright cylinders in the world frame W.
        origin: where the ray begins in W [m], shape (3,).
        direction: unit vector in W, shape (3,).
    """
    if not blocks.owners:
        return np.inf
    start = np.einsum("kij,ki->kj", blocks.rotations, origin - blocks.centres)
    along = np.einsum("kij,i->kj", blocks.rotations, direction)
    enter, leave = _between(start, along, blocks.halves)
    enter, leave = enter.max(axis=1), leave.min(axis=1)
    round_ = np.flatnonzero(np.isfinite(blocks.radii))
    if len(round_):
        first, last = _in_wall(start[round_], along[round_], blocks.radii[round_])
        enter[round_] = np.maximum(enter[round_], first)
        leave[round_] = np.minimum(leave[round_], last)
    met = (enter <= leave) & (leave >= 0.0)
    return float(np.maximum(enter[met], 0.0).min(initial=np.inf))


def _between(start: Array, along: Array, half: Array) -> tuple[Array, Array]:
    """Return where rays enter and leave slabs of half thickness `half` [m], shape (k, 3) each."""
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = (-half - start) / along, (half - start) / along
    flat = np.abs(along) < 1e-12
    within = np.abs(start) <= half
    enter = np.where(flat, np.where(within, -np.inf, np.inf), np.minimum(one, other))
    leave = np.where(flat, np.where(within, np.inf, -np.inf), np.maximum(one, other))
    return enter, leave


def _in_wall(start: Array, along: Array, radius: Array) -> tuple[Array, Array]:
    """Return where rays enter and leave round walls about z [m], shape (k,) each."""
    a = along[:, 0] ** 2 + along[:, 1] ** 2
    b = start[:, 0] * along[:, 0] + start[:, 1] * along[:, 1]
    c = start[:, 0] ** 2 + start[:, 1] ** 2 - radius**2
    flat, room = a < 1e-24, b * b - a * c
    root = np.sqrt(np.maximum(room, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        enter, leave = (-b - root) / a, (-b + root) / a
    passes = np.where(flat, c > 0.0, room < 0.0)
    enter = np.where(passes, np.inf, np.where(flat, -np.inf, enter))
    leave = np.where(passes, -np.inf, np.where(flat, np.inf, leave))
    return enter, leave
