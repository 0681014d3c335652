"""Fewer points for the same picture."""

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

Indices = npt.NDArray[np.intp]

_CELL = 0.2
"""Share of the tolerance within which samples count as one place."""

_MANY = 20_000
"""Above this number of places a curve is thinned by blocks first: the work grows with its length only."""

_BLOCK = 64
_BLOCK_SHARE = 0.2
"""Places of a block, and the share of the tolerance by which one may be off."""

SECTIONS = 300
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
    sections = np.split(known, np.flatnonzero(np.diff(known) > 1) + 1)
    if len(sections) > SECTIONS:
        sections = [known]
    bucket = -(-2 * known.size // points)
    return [section if bucket <= 2 else _thinned(values, section, bucket) for section in sections]


def along_curve(x: Array, y: Array, tolerance: float, points: int, kept: Indices) -> Indices:
    """Return indices that draw a plane curve, which is nowhere further from their polygon than a tolerance.

    The tolerance is doubled until at most `points` samples are left, not counting those in `kept`. After
    Douglas and Peucker (1973), between each two samples that are kept anyway.

    Args:
        x: shape (n,), finite.
        y: shape (n,), finite.
        tolerance: in the unit of x and y, > 0.
        points: maximum number.
        kept: samples that stay, such as the ends of moves; the first and the last one always stay.
    """
    if x.size == 0:
        return np.empty(0, dtype=np.intp)
    corners = np.unique(np.concatenate(([0, x.size - 1], kept)).astype(np.intp))
    while True:
        cells = np.round(np.stack([x, y]) / (_CELL * tolerance))
        near = np.concatenate(([True], np.any(np.diff(cells, axis=1) != 0.0, axis=0)))
        near[corners] = True
        indices = np.flatnonzero(near)
        ends = np.searchsorted(indices, corners)
        found = _thin(
            np.stack([x, y], axis=1)[indices], (1.0 - 2.0 * _CELL) * tolerance, ends, points + ends.size
        )
        if found is not None:
            return np.asarray(indices[found], dtype=np.intp)
        tolerance *= 2.0


def _thin(places: Array, tolerance: float, ends: Indices, most: int) -> Indices | None:
    """Return numbers of the places, (k, 2), that draw the curve, or None where there are more than `most`."""
    if len(places) <= _MANY:
        return _bends(places, tolerance, ends, most)
    blocks = np.union1d(ends, np.arange(0, len(places), _BLOCK))
    rough = _bends(places, _BLOCK_SHARE * tolerance, blocks, len(places))
    assert rough is not None  # there are not more than all of them
    found = _bends(places[rough], (1.0 - _BLOCK_SHARE) * tolerance, np.searchsorted(rough, ends), most)
    return None if found is None else rough[found]


def _bends(places: Array, tolerance: float, ends: Indices, most: int) -> Indices | None:
    """Return numbers of the places, (k, 2), between which the curve is as good as straight.

    All spans are halved at their farthest places at once. None where there are more numbers than `most`: a
    curve that fills the plane is not followed to its end.
    """
    found = [ends]
    count = ends.size
    first, last = ends[:-1], ends[1:]
    while True:
        if count > most:
            return None
        first, last = first[last - first >= 2], last[last - first >= 2]
        if first.size == 0:
            return np.asarray(np.sort(np.concatenate(found)), dtype=np.intp)
        lengths = last - first - 1
        begins = np.cumsum(lengths) - lengths
        span = np.repeat(np.arange(first.size), lengths)
        inner = np.arange(span.size) - begins[span] + first[span] + 1
        off = _away(places[inner] - places[first][span], (places[last] - places[first])[span])
        worst = np.maximum.reduceat(off, begins)
        at = np.flatnonzero(off == worst[span])
        middle = inner[at[np.searchsorted(at, begins)]]
        bent = worst > tolerance
        found.append(middle[bent])
        count += found[-1].size
        first, last = np.concatenate((first[bent], middle[bent])), np.concatenate((middle[bent], last[bent]))


def _away(places: Array, ways: Array) -> Array:
    """Return how far the places, (n, 2), are from the straight ways, (n, 2), all from the same begin."""
    length = np.maximum(np.einsum("ij,ij->i", ways, ways), 1e-300)
    share = np.clip(np.einsum("ij,ij->i", places, ways) / length, 0.0, 1.0)
    return np.asarray(np.linalg.norm(places - share[:, None] * ways, axis=1))


def _thinned(values: Array, section: Indices, bucket: int) -> Indices:
    full = section.size // bucket * bucket
    blocks, rest = section[:full].reshape(-1, bucket), section[full:]
    samples = values[blocks]
    rows = np.arange(blocks.shape[0])
    kept = [section[[0, -1]], blocks[rows, samples.argmin(axis=1)], blocks[rows, samples.argmax(axis=1)]]
    if rest.size:
        kept.append(rest[[int(np.argmin(values[rest])), int(np.argmax(values[rest]))]])
    return np.asarray(np.unique(np.concatenate(kept)), dtype=np.intp)
