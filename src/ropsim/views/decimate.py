"""Fewer points for the same picture."""

from itertools import pairwise

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

Indices = npt.NDArray[np.intp]

_CELL = 0.2
"""Share of the tolerance within which samples count as one place."""

PIECES = 300
"""Above this number of pieces a trace with gaps is drawn without them."""


def min_max(values: Array, points: int) -> list[Indices]:
    """Return indices of the samples to draw, one array per piece without a gap (NaN makes a gap).

    Each bucket of samples keeps its smallest and its largest one, each piece its ends, so no peak is lost.

    Args:
        values: shape (n,).
        points: how many samples to keep at most, the ends of pieces not counted.
    """
    known = np.flatnonzero(np.isfinite(values))
    if known.size == 0:
        return []
    pieces = np.split(known, np.flatnonzero(np.diff(known) > 1) + 1)
    if len(pieces) > PIECES:
        pieces = [known]
    bucket = -(-2 * known.size // points)
    return [piece if bucket <= 2 else _thinned(values, piece, bucket) for piece in pieces]


def along_curve(x: Array, y: Array, tolerance: float, points: int, kept: Indices) -> Indices:
    """Return indices that draw a plane curve, which is nowhere further from their polygon than a tolerance.

    The tolerance is doubled until at most `points` samples are left, those of `kept` not counted. After
    Douglas and Peucker (1973), between each two samples that are kept anyway.

    Args:
        x: shape (n,), finite.
        y: shape (n,), finite.
        tolerance: in the unit of x and y, > 0.
        points: at most so many.
        kept: samples that stay, such as the ends of moves; the first and the last one do so, too.
    """
    if x.size == 0:
        return np.empty(0, dtype=np.intp)
    while True:
        cells = np.round(np.stack([x, y]) / (_CELL * tolerance))
        moved = np.flatnonzero(np.any(np.diff(cells, axis=1) != 0.0, axis=0)) + 1
        ends = np.unique(np.concatenate(([0, x.size - 1], kept)).astype(np.intp))
        near = np.unique(np.concatenate((moved, ends)))
        places, found = np.stack([x, y], axis=1)[near], np.searchsorted(near, ends)
        bends = _bends(places, (1.0 - 2.0 * _CELL) * tolerance, found, points + ends.size)
        if bends is not None:
            return np.asarray(near[bends], dtype=np.intp)
        tolerance *= 2.0


def _bends(places: Array, tolerance: float, ends: Indices, most: int) -> Indices | None:
    """Return numbers of the places, (k, 2), between which the curve is as good as straight.

    None where there are more than `most`: a curve that fills the plane is not followed to its end.
    """
    found = ends.tolist()
    spans = list(pairwise(found))
    while spans:
        if len(found) > most:
            return None
        first, last = spans.pop()
        if last - first < 2:
            continue
        way, inner = places[last] - places[first], places[first + 1 : last] - places[first]
        share = np.clip(inner @ way / max(float(way @ way), 1e-300), 0.0, 1.0)
        off = np.linalg.norm(inner - share[:, None] * way, axis=1)
        worst = int(np.argmax(off))
        if off[worst] > tolerance:
            middle = first + 1 + worst
            found.append(middle)
            spans += [(first, middle), (middle, last)]
    return np.asarray(sorted(found), dtype=np.intp)


def _thinned(values: Array, piece: Indices, bucket: int) -> Indices:
    full = piece.size // bucket * bucket
    blocks, rest = piece[:full].reshape(-1, bucket), piece[full:]
    samples = values[blocks]
    rows = np.arange(blocks.shape[0])
    kept = [piece[[0, -1]], blocks[rows, samples.argmin(axis=1)], blocks[rows, samples.argmax(axis=1)]]
    if rest.size:
        kept.append(rest[[int(np.argmin(values[rest])), int(np.argmax(values[rest]))]])
    return np.asarray(np.unique(np.concatenate(kept)), dtype=np.intp)
