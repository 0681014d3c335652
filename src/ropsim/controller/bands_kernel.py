"""Bands that caps bring down, in plain loops that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[:,::1], f8[::1], i8, f8[:,::1], f8[:,::1], f8[:,::1])")
def bring_down(caps: Array, borders: Array, beside: int, before: Array, bounds: Array, causes: Array) -> None:
    """Bring the bounds of bands down to caps, and note what each of them was brought down for last.

    Args:
        caps: in columns kind, value, place from which and place up to which it counts, joint, quantity; of
            shape (6, h).
        borders: places between which the bands lie, shape (c + 1,).
        beside: bands on either side that are brought down with one.
        before: the bounds as they are, shape (3, c).
        bounds: the same; become no higher than the caps, shape (3, c).
        causes: joint and quantity of each band; become those of the last cap that binds, shape (2, c).
    """
    for h in range(caps.shape[1]):
        kind, value = int(caps[0, h]), caps[1, h]
        first, last = _bands_of(caps, h, borders, beside)
        for band in range(first, last + 1):
            bounds[kind, band] = min(bounds[kind, band], value)
    for h in range(caps.shape[1]):
        kind, value = int(caps[0, h]), caps[1, h]
        first, last = _bands_of(caps, h, borders, beside)
        for band in range(first, last + 1):
            if value == bounds[kind, band] and value < before[kind, band]:
                causes[0, band], causes[1, band] = caps[4, h], caps[5, h]


def _bands_of(caps: Array, h: int, borders: Array, beside: int) -> tuple[int, int]:
    """Return the first and the last band that a cap counts in."""
    most = borders.shape[0] - 2
    first, last = _behind(borders, caps[2, h]) - 1 - beside, _behind(borders, caps[3, h]) - 1 + beside
    return min(max(first, 0), most), min(max(last, 0), most)


def _behind(borders: Array, place: float) -> int:
    """Return the number of borders up to a place, itself included."""
    low, high = 0, borders.shape[0]
    while low < high:
        middle = (low + high) // 2
        if borders[middle] <= place:
            low = middle + 1
        else:
            high = middle
    return low
