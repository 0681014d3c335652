"""Fewer points for the same picture."""

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

Indices = npt.NDArray[np.intp]

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


def along_curve(x: Array, y: Array, step: float, points: int) -> Indices:
    """Return indices that draw a plane curve: samples at least `step` apart on a grid of that size.

    The step is doubled until at most `points` samples are left.

    Args:
        x: shape (n,), finite.
        y: shape (n,), finite.
        step: in the unit of x and y, > 0.
        points: at most so many.
    """
    while True:
        cells = np.round(np.stack([x, y]) / step)
        moved = np.any(np.diff(cells, axis=1) != 0.0, axis=0)
        kept = np.flatnonzero(np.concatenate([[x.size > 0], moved])[: x.size])
        if kept.size <= points:
            return kept
        step *= 2.0


def _thinned(values: Array, piece: Indices, bucket: int) -> Indices:
    full = piece.size // bucket * bucket
    blocks, rest = piece[:full].reshape(-1, bucket), piece[full:]
    samples = values[blocks]
    rows = np.arange(blocks.shape[0])
    kept = [piece[[0, -1]], blocks[rows, samples.argmin(axis=1)], blocks[rows, samples.argmax(axis=1)]]
    if rest.size:
        kept.append(rest[[int(np.argmin(values[rest])), int(np.argmax(values[rest]))]])
    return np.asarray(np.unique(np.concatenate(kept)), dtype=np.intp)
