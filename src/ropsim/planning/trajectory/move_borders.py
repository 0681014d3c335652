"""Borders of moves on path segments that many moves share: look-ahead counts moves there too."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.planning.trajectory.segments import PathSegment
from ropsim.spatial import Array, record

Counts = npt.NDArray[np.intp]
_SAME_PARAMETER = 1e-9
"""Share of a path segment below which two borders are one."""


@record
class OnMoves:
    """Path limits of which none lies on more than one move of a curve.

    Attributes:
        rows: of the path limits, the length first, shape (s, c).
        counts: how many of them each path segment has, shape (p,).
        moves: numbers of the moves in the order in which path limits lie on them, rising, shape (m,).
        of_moves: how many path limits lie on each, one or more, shape (m,).
    """

    rows: Array
    counts: Counts
    moves: Array
    of_moves: Array


def on_moves(path_segments: Sequence[PathSegment], rows: Array, counts: Counts) -> OnMoves:
    """Return path limits divided where the moves of a curve end.

    A path segment within one move, or round a blend, counts as a whole.

    Args:
        path_segments: in order.
        rows: path limits, the length first, of all path segments in a row, shape (s, c).
        counts: how many of them each path segment has, shape (p,).
    """
    numbers = np.array([path_segment.move_number for path_segment in path_segments], np.float64)
    if all(len(path_segment.ends) < 2 for path_segment in path_segments):
        return OnMoves(rows, counts, numbers, counts.astype(np.float64))
    lasts = np.cumsum(counts).tolist()
    parts, moves, of_moves = [], list[Array](), list[Array]()
    for path_segment, first, last in zip(path_segments, (0, *lasts[:-1]), lasts, strict=True):
        part = rows[first:last]
        on, many = np.zeros(1), np.array((last - first,))
        if len(path_segment.ends) > 1:
            part, owners = _divided(part, np.array(path_segment.ends))
            on, many = np.unique(owners, return_counts=True)
        parts.append(part)
        moves.append(path_segment.move_number + on)
        of_moves.append(many)
    return OnMoves(
        np.concatenate(parts),
        np.array([len(part) for part in parts], dtype=np.intp),
        np.concatenate(moves).astype(np.float64),
        np.concatenate(of_moves).astype(np.float64),
    )


def _divided(rows: Array, ends: Array) -> tuple[Array, Counts]:
    """Return path limits divided at path parameters, and for each how many of these lie before it.

    Args:
        rows: path limits of a path segment, the length first, shape (s, c).
        ends: path parameters, rising, shape (e,).
    """
    own = np.cumsum(rows[:, 0])
    length = float(own[-1])
    borders = np.unique(np.concatenate((own[:-1], ends)))
    near = _SAME_PARAMETER * length
    borders = borders[(np.diff(borders, prepend=0.0) > near) & (borders < length - near)]
    lengths = np.diff(borders, prepend=0.0, append=length)
    middles = np.append(borders, length) - 0.5 * lengths
    divided = rows[np.minimum(np.searchsorted(own, middles), len(rows) - 1)]
    divided[:, 0] = lengths
    return divided, np.searchsorted(ends, middles).astype(np.intp)
