"""Rows of a recording at which two convex bodies may penetrate each other, or are too near."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping

import numpy as np
import numpy.typing as npt

from ropsim.collision import Collisions
from ropsim.flow import Recording
from ropsim.simulation.ways.approaches import Nearest, Rows, TrackPairs, frames_at
from ropsim.spatial import Array, record

Mask = npt.NDArray[np.bool_]
"""True at the rows that are chosen."""


@record
class PairRows:
    """Two convex bodies at rows of a recording.

    Attributes:
        pair: its number.
        rows: of the recording, ascending, shape (k,).
        first: R_W by rows and p_W [m] of the first body, shape (k, 12).
        second: the same of the second body.
        most: upper bound of the depth at each row [m], shape (k,); no penetration where it is not positive.
        moved: bound of the motion up to each row, as the first body sees it [m], shape (k,): between two rows
            no point of the second body is displaced by more than the difference.
        gaps: distance at each row, 0 or less where they touch [m], shape (k,); inf where it is not needed.
    """

    pair: int
    rows: Rows
    first: Array
    second: Array
    most: Array
    moved: Array
    gaps: Array

    def at(self, chosen: Mask) -> "PairRows":
        """Return the pair at some of its rows."""
        return PairRows(
            self.pair,
            self.rows[chosen],
            self.first[chosen],
            self.second[chosen],
            self.most[chosen],
            self.moved[chosen],
            self.gaps[chosen],
        )


def pair_rows(
    solids: Collisions,
    checked: TrackPairs,
    seen: Nearest,
    recording: Recording,
    allowed: Callable[[int], float],
) -> Iterator[PairRows]:
    """Yield the rows around the episodes of each pair, with bounds of depth and with distances.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        seen: their episodes.
        recording: of the run.
        allowed: returns how deep the bodies of a pair may be in each other [m].
    """
    windows = _windows(checked, seen, recording.time)
    if not windows:
        return
    rows = np.unique(np.concatenate([*windows.values()]))
    Q = {
        name: recording.channels[recording.facts.channel("q", name)].values[rows].reshape(len(rows), -1)
        for name in solids.tree.mechanisms
    }
    frames = frames_at(solids, checked, Q)
    for pair, own in windows.items():
        a, b = checked.pairs[pair, :2].astype(int)
        at = np.searchsorted(rows, own)
        first, second = _poses(checked.items[a], frames, at), _poses(checked.items[b], frames, at)
        numbers = int(checked.items[a, 0]), int(checked.items[b, 0])
        most, moved = _bounds(solids, numbers, first, second)
        within = float(checked.pairs[pair, 6])
        wanted = most > (-within if within > 0.0 else allowed(pair))
        gaps = np.full(len(own), np.inf)
        if wanted.any():
            gaps[wanted] = solids.bodies.gaps(numbers, first[wanted], second[wanted])
        yield PairRows(pair, own, first, second, most, moved, gaps)


def _windows(checked: TrackPairs, seen: Nearest, time: Array) -> Mapping[int, Rows]:
    """Return the rows in and around the episodes of each pair."""
    spans: dict[int, list[tuple[int, int]]] = defaultdict(list)
    for pair, first, last in seen.episodes.tolist():
        spans[pair].append((first, last))
    found: dict[int, Rows] = {}
    for pair, some in sorted(spans.items()):
        start, end = np.searchsorted(time, checked.pairs[pair, 2:4])
        around = [
            np.arange(max(first - seen.step, start), min(last + seen.step, end - 1) + 1)
            for first, last in some
        ]
        found[pair] = np.unique(np.concatenate(around))
    return found


def _poses(item: Array, frames: Array, at: Rows) -> Array:
    """Return R_W by rows and p_W [m] of a convex body on its carrier, shape (k, 12)."""
    R, p = item[7:16].reshape(3, 3), item[16:19]
    carrier = int(item[1])
    if carrier < 0:
        return np.tile(np.concatenate([R.ravel(), p]), (len(at), 1))
    X = frames[carrier, at]
    R_W = X[:, :9].reshape(-1, 3, 3)
    return np.hstack([(R_W @ R).reshape(-1, 9), R_W @ p + X[:, 9:]])


def _bounds(solids: Collisions, numbers: tuple[int, int], first: Array, second: Array) -> tuple[Array, Array]:
    """Return upper bounds of the depth, and of the motion of the second body as the first one sees it.

    Two bodies are parted by a shift along an edge of one of the boxes around them; for two boxes whose faces
    meet this is the depth (separating axes: Gottschalk, Lin and Manocha 1996). From row to row a point moves
    by the shift s of the middle and 2·sin(θ/2)·r at most, for a turn by θ and a point at the distance r from
    the middle; chords are enough, since depths are compared at rows only.
    """
    (m_a, h_a), (m_b, h_b) = (solids.bodies.box(number) for number in numbers)
    R_a, R_b = first[:, :9].reshape(-1, 3, 3), second[:, :9].reshape(-1, 3, 3)
    between = R_b @ m_b + second[:, 9:] - R_a @ m_a - first[:, 9:]
    R = np.einsum("kji,kjl->kil", R_a, R_b)
    on_a, on_b = np.einsum("kji,kj->ki", R_a, between), np.einsum("kji,kj->ki", R_b, between)
    over_a = h_a + np.abs(R) @ h_b - np.abs(on_a)
    over_b = h_b + np.abs(R).transpose(0, 2, 1) @ h_a - np.abs(on_b)
    most = np.minimum(over_a.min(axis=1), over_b.min(axis=1))
    shift = np.linalg.norm(np.diff(on_a, axis=0), axis=1)
    turn = np.linalg.norm(np.diff(R, axis=0).reshape(-1, 9), axis=1) / np.sqrt(2.0)
    moved = np.concatenate([[0.0], np.cumsum(shift + float(np.linalg.norm(h_b)) * turn)])
    return most, moved
