"""How near convex bodies come to each other on ways: many pairs over the rows of a run."""

from collections.abc import Callable, Iterator

import numpy as np

from ropsim.collision.solid_bodies import SolidBodies
from ropsim.collision.ways_kernel import LEVELS, Certified, Movement, Search
from ropsim.spatial import Array, record

CAPACITY = 256
"""Episodes that are expected."""
AT_ONCE = 20_000
"""Number of pairs that are followed at once; compiled code is not interrupted."""
SPAN = 128.0
"""Rows of a span at most: halving begins there."""
TOLERANCE = 1e-4
"""The least distance is found to this [m]."""


@record
class Carriers:
    """Bodies that move over the rows of a run.

    Attributes:
        frames: R by rows and p [m] of each carrier by rows, shape (c, k, 12).
        deviation: most by which the origin [m] and the axes of each deviate from straight lines between two
            rows, shape (c, k - 1, 2).
    """

    frames: Array
    deviation: Array


@record
class Approach:
    """Result for pairs. Places are counted in rows; between two of them they are fractions.

    Attributes:
        least: least distance of the pairs that count [m]; inf if none was checked.
        gaps: least distance that was found of each pair [m], shape (p,); inf where another one was nearer.
        places: where that was, shape (p,).
        episodes: pair, begin and end of each span in which two may be nearer than they should, a place in it
            where they are, -1 where that cannot be told, and how far they may be off between rows [m]; shape
            (m, 5).
    """

    least: float
    gaps: Array
    places: Array
    episodes: Array


def carried(bodies: SolidBodies, number: int, carrier: int, X_CB: Array) -> Array:
    """Return the row of a convex body on a carrier for `certified`, shape (22,).

    Args:
        bodies: all of them.
        number: of the convex body.
        carrier: its number, -1 for none.
        X_CB: pose of the body that it belongs to in the frame of the carrier, shape (4, 4).
    """
    X = X_CB @ bodies.convexes[number].X_BC.matrix()
    middle, halves = bodies.box(number)
    radius = float(np.linalg.norm(halves))
    centre = X[:3, :3] @ middle + X[:3, 3]
    reach = float(np.linalg.norm(centre)) + radius
    return np.array([number, carrier, *centre, radius, reach, *X[:3, :3].ravel(), *X[:3, 3], *halves])


def certified(
    bodies: SolidBodies,
    items: Array,
    pairs: Array,
    carriers: Carriers,
    least: float = np.inf,
    progress: Callable[[float], None] = lambda _: None,
) -> Approach:
    """Return how near pairs come to each other: nothing nearer is left out, between rows neither.

    Args:
        bodies: the convex bodies.
        items: items on carriers, made by `carried`, shape (t, 22).
        pairs: numbers of two items, begin and end of the check by row, 1 where the least distance counts, 0
            where only episodes count, distance at which an episode begins [m]; shape (p, 6).
        carriers: moving bodies.
        least: a known distance of some pair [m]; larger distances are not refined.
        progress: called with the share of the spans that has been followed.
    """
    count = carriers.frames.shape[1]
    work = np.column_stack([pairs[:, :2], pairs[:, 4:6]])
    totals = np.array([least, 0.0, 0.0, 0.0])
    found = np.full((len(pairs) + 1, 7), np.inf)
    found[:, 2] = -1.0
    episodes = np.empty((CAPACITY, 5))
    spans = list(_spans(pairs[:, 2:4], count - 1.0))
    search = _search(len(items), len(carriers.frames), len(pairs), len(bodies.convexes))
    for k, (begin, end) in enumerate(spans):
        movement = Movement(carriers.frames, carriers.deviation, np.array([begin, end, TOLERANCE]))
        active = np.flatnonzero((pairs[:, 2] <= begin) & (pairs[:, 3] >= end))
        for first in range(0, len(active), AT_ONCE):
            some = active[first : first + AT_ONCE]
            search.active[0, : len(some)], search.levels[0] = some, len(some)
            before = totals.copy(), found.copy()
            while True:
                search.items[:, 7] = 0.0
                bodies.on_ways(items, work, movement, search, Certified(totals, found, episodes))
                if totals[1] <= len(episodes):
                    break
                more = np.empty((2 * int(totals[1]), 5))
                more[: len(episodes)] = episodes
                episodes = more
                totals[:], found[:] = before
        progress((k + 1) / len(spans))
    places = np.where(np.isfinite(found[:-1, 0]), found[:-1, 1], 0.0)
    return Approach(float(totals[0]), found[:-1, 0].copy(), places, episodes[: int(totals[1])].copy())


def _spans(ends: Array, last: float) -> Iterator[tuple[float, float]]:
    """Yield spans of rows in which each pair is checked from begin to end or not at all."""
    cuts = np.unique(np.concatenate([ends.clip(0.0, last).ravel(), np.arange(0.0, last, SPAN), [last]]))
    if len(cuts) == 1:
        yield last, last
    yield from zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True)


def _search(items: int, carriers: int, pairs: int, solids: int) -> Search:
    """Return the work arrays of a search."""
    return Search(
        np.empty((LEVELS, min(max(pairs, 1), AT_ONCE))),
        np.zeros(LEVELS),
        np.empty((2 * LEVELS, 3)),
        np.empty((carriers, 16)),
        np.zeros((items, 8)),
        np.zeros((pairs, 3)),
        np.zeros((solids, 12)),
        np.zeros((17, 4)),
    )
