"""Nearest: how far points are from a curve, by search over a grid and Newton's method."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

IntArray = npt.NDArray[np.int64]

_BLOCK = 64  # grid points that share one ball
_STEPS = 16  # of Newton's method at most; it starts within one step of the grid and doubles its digits
_CLOSE = 1e-9  # steps of the grid; the distance is flat at the nearest point, so its error is far smaller
_APART = 3  # steps of the grid beyond which a point is of another part of the curve that comes near
_PAIRS = 2**18  # of points and balls that are compared at a time


def distances(points: Array, curve: Callable[[Array], tuple[Array, Array, Array]], grid: Array) -> Array:
    """Return how far points are from a curve.

    The nearest point of the grid is found exactly, and the nearest one of another part of the curve: where
    that crosses or closes itself, the nearer point of the grid may be on the farther part. The grid is
    divided into blocks, a ball around each bounds how near it can be, and blocks are searched in the order of
    that bound. From both points Newton's method goes to where the offset is normal to the curve, or to an
    end; the nearer of both counts.

    Args:
        points: shape (k, 3) [m].
        curve: positions [m] and their first and second derivatives at parameters, shape (k,) to (k, 3) each.
        grid: growing parameters, shape (m,), m >= 2, so fine that the nearest point is a neighbour of the
            nearest one of the grid: between two of them the curve turns by less than half a right angle. Of
            points that are equally far within that (points near the centre of an arc) any one may be found,
            and of more than two parts of the curve that come within a step of each other.

    Returns:
        distances [m], shape (k,).
    """
    positions = curve(grid)[0]
    near = _nearest(points, positions, np.full(len(points), -_APART - 1))
    found = _down_from(near, points, curve, grid)
    if len(grid) > 2 * _APART + 1:
        other = _down_from(_nearest(points, positions, near), points, curve, grid)
        found = np.minimum(found, other)
    return found


def _down_from(
    near: IntArray, points: Array, curve: Callable[[Array], tuple[Array, Array, Array]], grid: Array
) -> Array:
    """Return the distance of each point at the foot of the slope on which a point of the grid lies, (k,).

    The sign of the slope says on which side of a parameter the foot is. A step of Newton's method beyond a
    parameter that is known to be on the other side is replaced by half of the way to it, for derivatives jump
    from segment to segment.
    """
    t = grid[near]
    low, high = grid[np.maximum(near - 1, 0)], grid[np.minimum(near + 1, len(grid) - 1)]
    step = high - low
    is_below, is_above = np.zeros((2, len(points)), dtype=bool)  # whether the foot is known to be so
    best = np.full(len(points), np.inf)
    for _ in range(_STEPS):
        p, d1, d2 = curve(t)
        offset = p - points
        best = np.minimum(best, _lengths(offset))
        slope, square = np.einsum("ki,ki->k", offset, d1), np.einsum("ki,ki->k", d1, d1)
        bend = square + np.einsum("ki,ki->k", offset, d2)
        # beyond the centre of a bend the distance has a greatest value there: the square alone leads down
        wanted = t - slope / np.where(bend > 0.0, bend, square)
        low, high = np.where(slope < 0.0, t, low), np.where(slope > 0.0, t, high)
        is_above, is_below = is_above | (slope < 0.0), is_below | (slope > 0.0)
        is_other_side = (is_above & (wanted <= low)) | (is_below & (wanted >= high))
        before, t = t, np.where(is_other_side, 0.5 * (low + high), np.clip(wanted, low, high))
        if (np.abs(t - before) <= _CLOSE * step).all():
            break
    return np.asarray(np.minimum(best, _lengths(curve(t)[0] - points)))


def _nearest(points: Array, positions: Array, barred: IntArray) -> IntArray:
    """Return which of the points (m, 3) is nearest to each point (k, 3), shape (k,).

    Grid points next to the barred one of a point, shape (k,), do not count.
    """
    starts = np.arange(0, len(positions), _BLOCK)
    sizes = np.diff(starts, append=len(positions))
    centres = np.add.reduceat(positions, starts) / sizes[:, None]
    radii = np.maximum.reduceat(_lengths(positions - np.repeat(centres, sizes, axis=0)), starts)
    at_once = max(1, _PAIRS // len(starts))
    nearest = [
        _nearest_in_blocks(points[k : k + at_once], positions, centres, radii, barred[k : k + at_once])
        for k in range(0, len(points), at_once)
    ]
    return np.concatenate([*nearest, np.empty(0, np.int64)])


def _nearest_in_blocks(
    points: Array, positions: Array, centres: Array, radii: Array, barred: IntArray
) -> IntArray:
    bounds = _lengths(points[:, None] - centres) - radii  # no point of the block is nearer
    order = np.argsort(bounds, axis=1)
    found, best = np.zeros(len(points), np.int64), np.full(len(points), np.inf)
    open_points = np.arange(len(points))
    for rank in range(len(radii)):
        block = order[open_points, rank]
        is_open = bounds[open_points, block] < best[open_points]
        open_points, block = open_points[is_open], block[is_open]
        if not len(open_points):
            break
        rows = np.minimum(block[:, None] * _BLOCK + np.arange(_BLOCK), len(positions) - 1)
        lengths = _lengths(positions[rows] - points[open_points, None])
        lengths[np.abs(rows - barred[open_points, None]) <= _APART] = np.inf
        row = np.argmin(lengths, axis=1)[:, None]
        least = np.take_along_axis(lengths, row, axis=1)[:, 0]
        is_better = least < best[open_points]
        better = open_points[is_better]
        best[better] = least[is_better]
        found[better] = np.take_along_axis(rows, row, axis=1)[is_better, 0]
    return found


def _lengths(vectors: Array) -> Array:
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", vectors, vectors)))
