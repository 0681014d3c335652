"""Ways along a part that are slower than they were planned, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.motion import times_along
from ropsim.spatial import Array

START, STOP, SHARE, BAND = range(4)
"""Rows of ways."""
_TINY = 1e-300


@kernel(
    "void(f8[::1], f8[::1], f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8,"
    " f8[:,::1], f8[:,::1], f8[::1])"
)
def slower_ways(
    borders: Array,
    times: Array,
    owners: Array,
    begins: Array,
    planned: Array,
    bounds: Array,
    causes: Array,
    segments: Array,
    ends: Array,
    most: float,
    room: Array,
    ways: Array,
    told: Array,
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
        room: to work in, shape (3, 2·c).
        ways: where they go: from when and until when [s], share of the greatest speed that is left in the
            slowest band, and its number; shape (4, c).
        told: where the number of ways goes, shape (1,).
    """
    last, count = planned.shape[1] - 1, 0
    for band in range(last + 1):
        if _is_lower(planned, bounds, band):
            for border in range(
                band if band == 0 or not _is_lower(planned, bounds, band - 1) else band + 1, band + 2
            ):
                piece = owners[min(border, last)]
                room[0, count], room[1, count] = piece, borders[border] - begins[int(piece)]
                count += 1
    times_along(segments, ends, room[0, :count], room[1, :count], room[2, :count])
    way, k, band = 0, 0, 0
    while band <= last:
        if not _is_lower(planned, bounds, band):
            band += 1
            continue
        ways[START, way], ways[SHARE, way], ways[BAND, way] = room[2, k], 1.0, -1.0
        while band <= last and _is_lower(planned, bounds, band):
            if causes[0, band] >= 0.0:
                length = borders[band + 1] - borders[band]
                now = length / max(room[2, k + 1] - room[2, k], _TINY)
                then = length / max(times[band + 1] - times[band], _TINY)
                share = min(1.0 - (then - now) / most, 1.0)
                if ways[BAND, way] < 0.0 or share < ways[SHARE, way]:
                    ways[SHARE, way], ways[BAND, way] = share, band
            band += 1
            k += 1
        ways[STOP, way] = room[2, k]
        k += 1
        if ways[BAND, way] >= 0.0:
            way += 1
    told[0] = way


def _is_lower(planned: Array, bounds: Array, band: int) -> bool:
    """Return whether a bound of a band was brought down."""
    return bool(
        bounds[0, band] < planned[0, band]
        or bounds[1, band] < planned[1, band]
        or bounds[2, band] < planned[2, band]
    )
