"""How near convex bodies come to each other on ways: many pairs over the rows of a run."""

from collections.abc import Callable

import numpy as np

from ropsim.collision.solid_bodies import Rows, SolidBodies
from ropsim.spatial import Array, record

CAPACITY = 256
"""Episodes that are expected."""
AT_ONCE = 2000
"""Number of pairs that are followed between progress reports: compiled code is not interrupted."""


@record
class Carriers:
    """Bodies that move over the rows of a run.

    Attributes:
        frames: R_W by rows and p_W [m] of each carrier by rows, shape (c, k, 12).
        travel: how far the origin of each has come at most at each row [m], how far it has turned [rad]; then
            the same of carriers as others see them, shape (t, 2, k).
    """

    frames: Array
    travel: Array


@record
class Approach:
    """Result for pairs.

    Attributes:
        least: least distance of the pairs that count [m]; inf if none was checked.
        gaps: least distance that was found of each pair [m], shape (p,); inf where another one was nearer.
        rows: where that was, shape (p,).
        near: numbers of the rows behind which a pair may come nearer still.
        episodes: pair, first and last row of each episode in which two are near enough, shape (m, 3).
    """

    least: float
    gaps: Array
    rows: Rows
    near: Rows
    episodes: Rows


def carried(bodies: SolidBodies, number: int, carrier: int, X_CB: Array) -> Array:
    """Return the row of a convex body on a carrier for `closest`, shape (22,).

    Args:
        bodies: all of them.
        number: of the convex body.
        carrier: its number, -1 for the world.
        X_CB: pose of the body that it belongs to in the frame of the carrier, shape (4, 4).
    """
    X = X_CB @ bodies.convexes[number].X_BC.matrix()
    middle, halves = bodies.box(number)
    radius = float(np.linalg.norm(halves))
    centre = X[:3, :3] @ middle + X[:3, 3]
    reach = float(np.linalg.norm(centre)) + radius
    return np.array([number, carrier, *centre, radius, reach, *X[:3, :3].ravel(), *X[:3, 3], *halves])


def closest(
    bodies: SolidBodies,
    items: Array,
    pairs: Array,
    carriers: Carriers,
    least: float = np.inf,
    progress: Callable[[float], None] = lambda _: None,
) -> Approach:
    """Return how near pairs come to each other.

    Args:
        bodies: the convex bodies.
        items: items on carriers, made by `carried`, shape (t, 22).
        pairs: numbers of two items, first row, the one behind the last, 1 where the least distance counts, 0
            where only episodes count, row of `travel` with the motion of the second carrier relative to the
            first, -1 where the motions of both are added, distance at which an episode begins [m]; shape (p,
            7).
        carriers: moving bodies.
        least: a known distance of some pair [m]; larger distances are not refined.
        progress: called with the share of the pairs that has been followed.
    """
    near = np.zeros(carriers.frames.shape[1])
    parts, episodes_found = [np.empty((0, 2))], [np.empty((0, 3))]
    for first in range(0, len(pairs), AT_ONCE):
        least, found, episodes = _followed(
            bodies, items, pairs[first : first + AT_ONCE], carriers, least, near
        )
        parts.append(found)
        episodes_found.append(episodes + np.array([first, 0.0, 0.0]))
        progress(min(first + AT_ONCE, len(pairs)) / len(pairs))
    gaps, rows = np.concatenate(parts).T
    return Approach(
        least,
        gaps,
        rows.astype(np.intp),
        np.flatnonzero(near),
        np.concatenate(episodes_found).astype(np.intp),
    )


def _followed(
    bodies: SolidBodies, items: Array, pairs: Array, carriers: Carriers, least: float, near: Array
) -> tuple[float, Array, Array]:
    """Follow pairs; return the least distance, gaps with their rows, and episodes."""
    capacity = CAPACITY
    while True:
        known = np.array([least, 0.0])
        found, episodes = np.empty((len(pairs) + 1, 7)), np.empty((capacity, 3))
        bodies.on_paths(items, pairs, (carriers.frames, carriers.travel), (known, found, near, episodes))
        count = int(known[1])
        if count <= capacity:
            break
        capacity = count
    return float(known[0]), found[:-1, :2], episodes[:count]
