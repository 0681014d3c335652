"""Places of a recording at which two convex bodies may penetrate each other, or are too near."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping

import numpy as np
import numpy.typing as npt

from ropsim.collision import Collisions
from ropsim.simulation.ways.approaches import Nearest, TrackPairs
from ropsim.simulation.ways.carrier_motion import Motion, frames_of
from ropsim.spatial import Array, record

Mask = npt.NDArray[np.bool_]
"""True at the rows that are chosen."""
STEP = 5e-5
"""Between two rows depths are computed at places so near to each other [m]."""
MOST_STEPS = 400
"""Places between two rows at most."""
MOST_PLACES = 20_000
"""Places between rows of a pair at most; there are more only where an arm has run away."""


@record
class PairRows:
    """Two convex bodies at places of a recording: its rows, and others where they may meet between two.

    Attributes:
        pair: its number.
        rows: places, counted in rows, ascending, shape (k,).
        first: R_W by rows and p_W [m] of the first body, shape (k, 12).
        second: the same of the second body.
        most: upper bound of the depth at each place [m], shape (k,); no penetration where it is not positive.
        moved: bound of the motion up to each place, as the first body sees it [m], shape (k,): between two
            places no point of the second body is displaced by more than the difference.
        gaps: distance at each place, 0 or less where they touch [m], shape (k,); inf where it is not needed.
    """

    pair: int
    rows: Array
    first: Array
    second: Array
    most: Array
    moved: Array
    gaps: Array

    def at(self, chosen: Mask) -> "PairRows":
        """Return the pair at some of its places."""
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
    motion: Motion,
    allowed: Callable[[int], float],
) -> Iterator[PairRows]:
    """Yield the rows around the episodes of each pair, with bounds of depth and with distances.

    Between two rows at which bodies are no deeper in each other than they may be, but may be so on the way,
    there are further places.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        seen: their episodes.
        motion: of the joints.
        allowed: returns how deep the bodies of a pair may be in each other [m].
    """
    windows = _windows(checked, seen, motion.time)
    if not windows:
        return
    looking = _Looking(solids, checked, motion)
    rows = np.unique(np.concatenate([*windows.values()]))
    frames = looking.frames(rows)
    for pair, own in windows.items():
        within, limit = float(checked.pairs[pair, 5]), allowed(pair)
        least = -within if within > 0.0 else limit
        at_rows = looking.at(pair, own, frames[:, np.searchsorted(rows, own)], least)
        between = _between(at_rows, limit)
        if not len(between):
            yield at_rows
            continue
        every = np.union1d(own, between)
        found = looking.at(pair, every, looking.frames(every), least)
        is_row = np.isin(every, own)
        yield found.at(is_row | ((found.gaps <= 0.0) & (found.most > limit)))


def rows_at(solids: Collisions, checked: TrackPairs, motion: Motion, pair: int, places: Array) -> PairRows:
    """Return a pair at places, counted in rows, shape (k,)."""
    looking = _Looking(solids, checked, motion)
    return looking.at(pair, places, looking.frames(places), -np.inf)


class _Looking:
    """Looks at pairs at places of a recording."""

    def __init__(self, solids: Collisions, checked: TrackPairs, motion: Motion) -> None:
        self._solids, self._checked, self._motion = solids, checked, motion

    def frames(self, places: Array) -> Array:
        """Return the frames of the carriers at places, shape (c, k, 12)."""
        return frames_of(self._solids.tree, self._checked.carriers, self._motion.at(places))

    def at(self, pair: int, places: Array, frames: Array, least: float) -> PairRows:
        """Return a pair at places, with distances where the bound of the depth is more than the least one."""
        bodies, items = self._solids.bodies, self._checked.items
        a, b = self._checked.pairs[pair, :2].astype(int)
        first, second = _poses(items[a], frames), _poses(items[b], frames)
        numbers = int(items[a, 0]), int(items[b, 0])
        most, moved = _bounds(self._solids, numbers, first, second)
        wanted, gaps = most > least, np.full(len(places), np.inf)
        if wanted.any():
            gaps[wanted] = bodies.gaps(numbers, first[wanted], second[wanted])
        return PairRows(pair, places, first, second, most, moved, gaps)


def _between(rows: PairRows, allowed: float) -> Array:
    """Return places between rows at which two bodies may be deeper in each other than allowed, shape (k,).

    They are so near to each other that the bodies move by `STEP` at most from one to the next one.
    """
    is_deep = (rows.gaps <= 0.0) & (rows.most > allowed)
    way = np.diff(rows.moved)
    most = (rows.most[:-1] + rows.most[1:] + way) / 2.0
    chosen = (np.diff(rows.rows) <= 1.0) & ~is_deep[:-1] & ~is_deep[1:] & (most > allowed)
    found = [np.empty(0)]
    counts = np.clip(np.ceil(way / STEP), 2, MOST_STEPS) * chosen
    counts = np.maximum(counts * min(1.0, MOST_PLACES / max(float(counts.sum()), 1.0)), 2.0)
    for k in np.flatnonzero(chosen).tolist():
        count = int(counts[k])
        found.append(rows.rows[k] + (rows.rows[k + 1] - rows.rows[k]) * np.arange(1, count) / count)
    return np.concatenate(found)


def _windows(checked: TrackPairs, seen: Nearest, time: Array) -> Mapping[int, Array]:
    """Return the rows in and next to the episodes of each pair."""
    spans: dict[int, list[tuple[int, int]]] = defaultdict(list)
    for pair, begin, end in seen.episodes[:, :3].tolist():
        spans[int(pair)].append((int(np.floor(begin)), int(np.ceil(end))))
    found: dict[int, Array] = {}
    for pair, some in sorted(spans.items()):
        start, end = np.searchsorted(time, checked.pairs[pair, 2:4])
        around = [np.arange(max(first - 1, start), min(last + 1, end - 1) + 1) for first, last in some]
        found[pair] = np.unique(np.concatenate(around)).astype(np.float64)
    return found


def _poses(item: Array, frames: Array) -> Array:
    """Return R_W by rows and p_W [m] of a convex body on its carrier, shape (k, 12)."""
    R, p = item[7:16].reshape(3, 3), item[16:19]
    carrier = int(item[1])
    if carrier < 0:
        return np.tile(np.concatenate([R.ravel(), p]), (frames.shape[1], 1))
    X = frames[carrier]
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
