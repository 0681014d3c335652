"""Rows at which two bodies are deeper in each other than they may be."""

from collections.abc import Sequence

import numpy as np

from ropsim.collision import COARSE, Collisions, Nearness
from ropsim.simulation.ways.approaches import TrackPairs
from ropsim.simulation.ways.episodes import PairRows

MOST_ROWS = 400
"""Maximum number of rows of a contact at which the depth is computed; undecided rows count as deep."""


def deep_rows(
    solids: Collisions, checked: TrackPairs, parts: Sequence[PairRows], allowed: float
) -> list[PairRows]:
    """Return the convex bodies of a contact, at the rows where any two of them are deeper than they may be.

    Between two rows a depth changes by the way in between at most, so that one that is computed decides on
    the rows around it.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        parts: the convex bodies of two bodies, at rows at which they touch.
        allowed: how deep they may be in each other [m].
    """
    rows = np.unique(np.concatenate([one.rows for one in parts]))
    where = [np.searchsorted(rows, one.rows) for one in parts]
    most, least = [one.most.copy() for one in parts], [np.full(len(one.rows), -np.inf) for one in parts]
    is_deep = np.zeros(len(rows), dtype=bool)
    for _ in range(MOST_ROWS):
        is_open = [(up > allowed) & ~is_deep[at] for up, at in zip(most, where, strict=True)]
        number = int(np.argmax([np.count_nonzero(one) for one in is_open]))
        undecided = np.flatnonzero(is_open[number])
        if not len(undecided):
            break
        one, row = parts[number], int(undecided[len(undecided) // 2])
        depth, moved = -nearness_at(solids, checked, one, row).distance, np.abs(one.moved - one.moved[row])
        np.minimum(most[number], depth + moved, out=most[number])
        np.maximum(least[number], depth - moved, out=least[number])
        is_deep[where[number][least[number] > allowed]] = True
    for up, at in zip(most, where, strict=True):
        is_deep[at[up > allowed]] = True
    cut = [one.at(is_deep[at]) for one, at in zip(parts, where, strict=True)]
    return [one for one in cut if len(one.rows)]


def nearness_at(solids: Collisions, checked: TrackPairs, one: PairRows, row: int) -> Nearness:
    """Return how near two convex bodies are at a row.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        one: the two.
        row: number of the row among the rows of the two.
    """
    numbers = [int(number) for number in checked.items[checked.pairs[one.pair, :2].astype(int), 0]]
    poses = np.zeros((len(solids.bodies.convexes), 12))
    poses[numbers[0]], poses[numbers[1]] = one.first[row], one.second[row]
    found = solids.bodies.distances(poses, np.array([numbers]), np.zeros(1), (np.inf, np.inf))
    return solids.bodies.nearness(poses, numbers, found[0], COARSE)
