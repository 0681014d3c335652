"""The border of a section as closed lines, for drawings."""

import numpy as np

from ropsim.spatial import Array
from ropsim.workspace.volume.raster import Section

_SMOOTH = (0.25, 0.5, 0.25)
_SIDES = ((0, 0), (1, 0), (1, 1), (0, 1))  # the corners of a square of lattice points, round about


def outline(section: Section) -> tuple[Array, ...]:
    """Return the closed lines along the border of a section [m], each of shape (k, 2), the longest first.

    Marching squares (Lorensen & Cline 1987, in the plane) on the covered points, smoothed over three points
    of the lattice; a line is nearer to the border than the spacing of the lattice but at sharp corners.
    """
    field = np.pad(section.covered, 1)
    for axis in (0, 1):
        before, after = np.roll(field, 1, axis), np.roll(field, -1, axis)
        field = _SMOOTH[0] * before + _SMOOTH[1] * field + _SMOOTH[2] * after
    there = (field > 0.5).astype(np.int64)
    number = np.zeros((there.shape[0] - 1, there.shape[1] - 1), dtype=np.int64)
    for k, (i, j) in enumerate(_SIDES):
        number += there[i : i - 1 or None, j : j - 1 or None] << k
    following: dict[tuple[int, int, int], tuple[int, int, int]] = {}
    for i, j in zip(*np.nonzero((number > 0) & (number < 15)), strict=True):
        inside = [bool(number[i, j] >> k & 1) for k in range(4)]
        ends = [_edge(i, j, k) for k in range(4) if inside[k] != inside[(k + 1) % 4]]
        leaving = [k for k in range(4) if inside[k] and not inside[(k + 1) % 4]]
        for k in leaving:  # with the inside to the left, from its end to its begin
            begin = next(m % 4 for m in range(k + 3, k - 1, -1) if not inside[m % 4] and inside[(m + 1) % 4])
            following[_edge(i, j, k)] = _edge(i, j, begin)
        assert len(ends) == 2 * len(leaving)
    lines = []
    while following:
        start, nxt = following.popitem()
        chain = [start, nxt]
        while chain[-1] != start and chain[-1] in following:
            chain.append(following.pop(chain[-1]))
        lines.append(_places(section, field, chain))
    return tuple(sorted(lines, key=lambda one: -len(one)))


def _edge(i: int, j: int, k: int) -> tuple[int, int, int]:
    """Return an edge of a square: its lower lattice point, and 0 or 1 for the axis along which it lies."""
    return ((i, j, 0), (i + 1, j, 1), (i, j + 1, 0), (i, j, 1))[k]


def _places(section: Section, field: Array, chain: list[tuple[int, int, int]]) -> Array:
    """Return where a line crosses edges of the padded lattice, in the section [m]."""
    edges = np.array(chain)
    i, j, way = edges.T
    one, other = field[i, j], field[i + (way == 0), j + (way == 1)]
    share = (0.5 - one) / (other - one)
    at = np.column_stack((i + share * (way == 0), j + share * (way == 1))) - 1.0
    return section.placed(at)
