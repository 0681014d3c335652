"""How much of a meant contact can act at once: bodies may consist of several convex shapes."""

import numpy as np

from ropsim.collision import Convex
from ropsim.kinematics import body_poses
from ropsim.model import FLOOR, Cell, MeantContact, Station, body_tree, resisting_bodies, start_of
from ropsim.simulation.state.touching import own_bodies, solids_of
from ropsim.spatial import Array

COVERED = 1.4
"""Stiffness where a face covers a body under it as a whole, in that of a face that rests on a larger one."""


def shapes_at_once(cell: Cell, contact: MeantContact, station: Station) -> float:
    """Return an upper bound of the stiffness of a contact, in that of one pair of convex shapes.

    Each shape that an arm presses on others counts by itself, with all shapes that it can touch at once:
    these are no farther from one of them than it is long, as bodies stand at the start.

    Args:
        cell: that is run.
        contact: of it.
        station: whose arm moves.
    """
    tree, own = body_tree(cell), own_bodies(cell, contact, station.name)
    resisting = [name for name in resisting_bodies(cell, contact) if name not in own]
    solids = solids_of(tree, frozenset((*own, *resisting)))
    standing = [name for name in resisting if name in solids]
    q = {name: values[None] for name, values in start_of(cell).items()}
    poses = body_poses(tree, q, standing)
    placed = [(one, poses[name][0] @ one.X_BC.matrix()) for name in standing for one in solids[name]]
    boxes, edges = [_box(one, X) for one, X in placed], [np.sort(_edges(one)) for one, _ in placed]
    if FLOOR in resisting and FLOOR not in solids:
        boxes.append(np.array([[-np.inf] * 3, [np.inf, np.inf, 0.0]]))
        edges.append(np.full(3, np.inf))
    moving = [one for name in own for one in solids.get(name, ())]
    if not boxes:
        return 0.0
    return sum(_most(one, np.array(boxes), np.array(edges)) for one in moving)


def _most(moving: Convex, boxes: Array, edges: Array) -> float:
    """Return how much a shape can touch at once of others.

    Args:
        moving: the shape.
        boxes: least and greatest x, y, z of the others [m], shape (n, 2, 3).
        edges: of a box around each, the shortest first [m], shape (n, 3).
    """
    own = _edges(moving)
    length, (_, wide, long) = float(np.linalg.norm(own)), np.sort(own)
    is_ball = len(moving.points) == 1
    covers = (edges[:, 0] <= wide) & (edges[:, 1] <= long) & (not is_ball)
    shares, most = np.where(covers, COVERED, 1.0), 0.0
    for low, high in boxes:
        apart = np.maximum(np.maximum(low, boxes[:, 0]) - np.minimum(high, boxes[:, 1]), 0.0)
        most = max(most, float(shares[np.linalg.norm(apart, axis=1) <= length].sum()))
    return most


def _edges(one: Convex) -> Array:
    """Return the edges of the box around a shape in its own frame [m], shape (3,)."""
    low, high = one.bounds
    return np.asarray(high - low)


def _box(one: Convex, X_WC: Array) -> Array:
    """Return the least and greatest x, y, z of a box in W that holds a shape [m], shape (2, 3)."""
    low, high = one.bounds
    centre = X_WC[:3, :3] @ ((low + high) / 2.0) + X_WC[:3, 3]
    half = np.abs(X_WC[:3, :3]) @ ((high - low) / 2.0)
    return np.array([centre - half, centre + half])
