"""Arcs of answers of an arm with spherical shoulder and wrist, from its closed form over the swivel angle.

Between two swivel angles at which a joint may meet a limit, or shoulder or wrist may be straight, a branch is
within the limits everywhere or nowhere: one swivel angle between decides. So the arcs need not be followed,
and an elbow that is almost stretched, whose curves come near to each other, is no special case.
"""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from ropsim.kinematics.solutions.self_motion import Arc, Bools, narrow_limits, turned_within
from ropsim.spatial import Array

Branches = Callable[[Array], Array]
"""All branches at swivel angles (k,) [rad], shape (k, b, 7)."""
SAME = 1e-12
"""Swivel angles that differ by less are one [rad]."""
STEP = 0.1
"""Largest distance of two points of an arc [rad]."""
CLOSE = 1e-3
"""Swivel angle [rad] by which an answer with a joint at its limit may be off the closed form of a snapped
arm."""
APART = 0.5
"""Joints that change by more from point to point of a branch pass a singular configuration [rad]."""
TOUCHING = 1e-10
"""Distance of the points on both sides of a jump [rad]."""
TURN = 2.0 * np.pi


def swivel_arcs(branches: Branches, cuts: Array, ends: Array, at: Array, limits: Array) -> tuple[Arc, ...]:
    """Return the arcs of answers within the limits.

    Args:
        branches: of the pose.
        cuts: swivel angles between which a branch is within the limits everywhere or nowhere [rad], (m,).
        ends: answers within the limits, of which some have a joint at one [rad], shape (k, 7).
        at: swivel angles of these [rad], shape (k,).
        limits: lower and upper limits [rad], and 1.0 for joints that turn, shape (3, 7).
    """
    borders = np.sort(_principal(np.concatenate((cuts, at))))
    borders = borders[np.append(True, np.diff(borders) > SAME)]
    highs = np.append(borders[1:], borders[0] + TURN)
    rows = branches(0.5 * (borders + highs))
    count = rows.shape[1]
    inside = _turned(rows.reshape(-1, 7), limits)[1].reshape(len(borders), count)
    found = list[Arc]()
    for branch in range(count):
        for cells in _runs(inside[:, branch]):
            low, size = borders[cells], (highs - borders)[cells]
            found += _along(branches, branch, low[0], size, (ends, at), limits)
    return (*found, *_lone(found, ends, at, limits))


def _along(
    branches: Branches,
    branch: int,
    begin: float,
    sizes: Array,
    points: tuple[Array, Array],
    limits: Array,
) -> list[Arc]:
    """Return the arcs of a branch over cells in a row; more than one where the branch jumps.

    Args:
        branches: of the pose.
        branch: number of the branch.
        begin: swivel angle at which the first cell begins [rad].
        sizes: of the cells [rad], shape (c,).
        points: answers within the limits, and their swivel angles.
        limits: as above.
    """
    steps = [np.full(count := max(2, int(np.ceil(size / STEP))), size / count) for size in sizes.tolist()]
    swivels = begin + np.append(0.0, np.cumsum(np.concatenate(steps)))
    rows, inside = _turned(branches(swivels)[:, branch], limits)
    for end, inner in ((0, 1), (-1, -2)):
        if not inside[end]:
            _end_at(rows, swivels, inside, (end, inner), points, limits)
    swivels, rows = swivels[inside], rows[inside]
    while len(wide := np.flatnonzero(_jumps(rows, limits) & (np.diff(swivels) > TOUCHING))):
        between = 0.5 * (swivels[wide] + swivels[wide + 1])
        more, inside = _turned(branches(between)[:, branch], limits)
        if not inside.any():
            break
        wide, between, more = wide[inside], between[inside], more[inside]
        swivels, rows = np.insert(swivels, wide + 1, between), np.insert(rows, wide + 1, more, axis=0)
    places = np.flatnonzero(_jumps(rows, limits)) + 1
    parts = zip(np.split(rows, places), np.split(swivels, places), strict=True)
    return [(part, values) for part, values in parts if len(part)]


def _end_at(
    rows: Array,
    swivels: Array,
    inside: Bools,
    place: tuple[int, int],
    points: tuple[Array, Array],
    limits: Array,
) -> None:
    """Let an arc end at the answer with a joint at its limit that is next to its end, if there is one."""
    (end, inner), (ends, at) = place, points
    off = _principal(at - swivels[end])
    away = np.abs(_apart(ends, rows[inner], limits)).max(axis=1, initial=0.0)
    away[np.abs(off) > CLOSE] = np.inf
    nearest = int(np.argmin(away)) if len(away) else -1
    if nearest >= 0 and away[nearest] < APART:
        rows[end], inside[end] = ends[nearest], True
        swivels[end] += off[nearest]


def _lone(found: Sequence[Arc], ends: Array, at: Array, limits: Array) -> Iterator[Arc]:
    """Yield answers that are on no arc: a pose may be reached in a point only."""
    for q, value in zip(ends, at.tolist(), strict=True):
        near = (np.abs(_apart(rows, q, limits)).max(axis=1).min() < APART for rows, _ in found)
        if not any(near):
            yield q[np.newaxis], np.array([value])


def _jumps(rows: Array, limits: Array) -> Bools:
    """Return where a branch jumps from point to point, shape (s - 1,)."""
    return np.asarray(np.abs(_apart(rows[1:], rows[:-1], limits)).max(axis=1, initial=0.0) > APART)


def _turned(rows: Array, limits: Array) -> tuple[Array, Bools]:
    """Return branches (m, 7) in the turn within the limits, and which have one."""
    turned, inside = turned_within(rows, narrow_limits(limits), limits[2])
    return turned, inside & ~np.isnan(rows[:, 0])


def _runs(inside: Bools) -> Iterator[list[int]]:
    """Yield the cells of each run of cells that are inside, on a circle."""
    count = len(inside)
    if inside.all():
        yield list(range(count))
        return
    for first in np.flatnonzero(inside & ~np.roll(inside, 1)).tolist():
        cells = [first]
        while inside[(cells[-1] + 1) % count]:
            cells.append((cells[-1] + 1) % count)
        yield cells


def _apart(rows: Array, others: Array, limits: Array) -> Array:
    """Return differences of joint coordinates without whole turns of joints that turn."""
    apart = rows - others
    return np.asarray(apart - limits[2] * TURN * np.round(apart / TURN))


def _principal(angles: Array) -> Array:
    """Return angles in (-π, π] [rad]."""
    return np.asarray(angles - TURN * np.ceil((angles - np.pi) / TURN))
