"""Ways along a part that are slower than they were planned, in a loop that numba compiles."""

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion import times_along
from ropsim.spatial import Array

START, STOP, SHARE, BAND = range(4)
"""Rows of ways."""
_TINY = 1e-300


@kernel
def slower_ways(
    borders: Array1,
    times: Array1,
    owners: Array1,
    begins: Array1,
    planned: Array2,
    bounds: Array2,
    causes: Array2,
    segments: Array2,
    ends: Array1,
    most: float,
    room: Array2,
    ways: Array2,
    told: Array1,
) -> None:
    """Write ways on which bounds were brought down, and the named band of each that loses most of the speed.

    Args:
        borders: places between which the bands lie, shape (c + 1,).
        times: at which the motion would be there before joints counted [s], shape (c + 1,).
        owners: number of the piece on which each band lies, rising, shape (c,).
        begins: places at which pieces begin, shape (p or more,).
        planned: bounds before joints counted, shape (3, c).
        bounds: the same with regard to joints, shape (3, c).
        causes: joint and quantity of each band, below 0 where it has none, shape (2, c).
        segments: of the time law, see `TimeLaw`, shape (8, m).
        ends: times at which its pieces end [s], shape (p,).
        most: greatest speed before joints counted.
        room: to work in: of each border its piece, place on it, time [s], and the band before it, -1 where a
            way begins, shape (4, 2·c).
        ways: where they go: from when and until when [s], share of the greatest speed that is left in the
            slowest band, and its number; shape (4, c).
        told: where the number of ways goes, shape (1,).
    """
    last, count, goes_on = planned.shape[1] - 1, 0, False
    for band in range(last + 1):
        lower = (
            (bounds[0, band] < planned[0, band])
            | (bounds[1, band] < planned[1, band])
            | (bounds[2, band] < planned[2, band])
        )
        if lower:
            if not goes_on:
                count = _ask(borders, owners, begins, band, -1, room, count)
            count = _ask(borders, owners, begins, band + 1, band, room, count)
        goes_on = lower
    times_along(segments, ends, room[0, :count], room[1, :count], room[2, :count])
    way = 0
    for k in range(count):
        band = int(room[3, k])
        if band < 0:
            ways[START, way], ways[SHARE, way], ways[BAND, way] = room[2, k], 1.0, -1.0
            continue
        if causes[0, band] >= 0.0:
            length = borders[band + 1] - borders[band]
            now = length / max(room[2, k] - room[2, k - 1], _TINY)
            then = length / max(times[band + 1] - times[band], _TINY)
            share = min(1.0 - (then - now) / most, 1.0)
            if ways[BAND, way] < 0.0 or share < ways[SHARE, way]:
                ways[SHARE, way], ways[BAND, way] = share, band
        if k + 1 == count or room[3, k + 1] < 0.0:
            ways[STOP, way] = room[2, k]
            if ways[BAND, way] >= 0.0:
                way += 1
    told[0] = way


def _ask(
    borders: Array, owners: Array, begins: Array, border: int, band: int, room: Array, count: int
) -> int:
    """Write piece and place of a border, and the band that ends there or -1; return the number of all."""
    piece = owners[min(border, owners.shape[0] - 1)]
    room[0, count], room[1, count], room[3, count] = piece, borders[border] - begins[int(piece)], band
    return count + 1
