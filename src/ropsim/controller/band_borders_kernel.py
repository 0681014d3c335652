"""Between which times and places bands lie, in loops that numba compiles."""

from math import ceil, inf, log, sqrt

import numpy as np

from ropsim.codegen import kernel
from ropsim.motion import rows_at, time_at
from ropsim.spatial import Array

SPEED, ACCELERATION, JERK = range(3)
"""Rows of what is used."""
PIECE, TIME = 4, 5
"""Rows of bands, behind place and bounds."""
MOST_PARTS = 64
"""Into which a way is divided, at most."""
STEEP = 0.4
"""Greatest change of the logarithm of the speed that joints allow between two times, about."""


@kernel("void(f8[:,::1], f8[::1], f8, f8[:,::1], f8[::1], f8[::1])")
def band_times(used: Array, phi: Array, duration: float, ways: Array, times: Array, told: Array) -> None:
    """Write motion times that are about one real time apart, as dense as a motion must be slow there.

    Even ways between two times are divided by the rate that they and their neighbours leave, and where the
    speed that joints allow changes steeply.

    Args:
        used: of the limits at control ticks, in the order of `Quantity`, shape (4, k).
        phi: motion times of the ticks, rising [s], shape (k,).
        duration: motion time at the end [s].
        ways: room to work in for w even ways, shape (2, w).
        times: where they go, from 0 to the end, rising, shape (64 · w + 1,).
        told: where their number goes, shape (1,).
    """
    last = ways.shape[1] - 1
    step = duration / (last + 1)
    for way in range(last + 1):
        ways[0, way], ways[1, way] = 1.0, 0.0
    here, before = 0, 0.0
    for k in range(phi.shape[0]):
        while here < last and (here + 1) * step <= phi[k]:
            here += 1
        if used[ACCELERATION, k] > 1.0:
            ways[0, here] = max(ways[0, here], sqrt(used[ACCELERATION, k]))
        if used[JERK, k] > 1.0:
            ways[0, here] = max(ways[0, here], np.cbrt(used[JERK, k]))
        if before > 0.0 or used[SPEED, k] > 1.0:
            ways[0, here] = max(ways[0, here], used[SPEED, k])
            now = log(max(used[SPEED, k], 1.0))
            ways[1, here] += abs(now - before)
            before = now
    count = 0
    for way in range(last + 1):
        need = max(ways[0, max(way - 1, 0)], ways[0, way], ways[0, min(way + 1, last)])
        parts = int(min(max(ceil(need), ceil(ways[1, way] / STEEP)), MOST_PARTS))
        begin, end = way * step, duration if way == last else (way + 1) * step
        for part in range(parts):
            times[count] = begin + (end - begin) * (part / parts)
            count += 1
    times[count] = duration
    told[0] = count + 1


@kernel(
    "void(f8[:,::1], f8[::1], f8, f8[::1], f8[::1], f8[:,::1], f8[::1], f8, f8[::1], f8[:,::1], f8[:,::1],"
    " f8[::1])"
)
def lay_bands(
    segments: Array,
    ends: Array,
    start: float,
    times: Array,
    begins: Array,
    stages: Array,
    counts: Array,
    near: float,
    asked: Array,
    law: Array,
    bands: Array,
    told: Array,
) -> None:
    """Write the bands of a part, between the places where it is at times, and where stages end.

    Args:
        segments: of its time law, see `TimeLaw`, shape (8, m).
        ends: times at which its pieces end [s], shape (p,).
        start: motion time at which it begins [s].
        times: motion times, rising [s], shape (k,).
        begins: places at which pieces begin, and the end of the last one, shape (p + 1,).
        stages: length, and bounds of speed, acceleration and jerk of each stage, shape (s, 4).
        counts: how many stages each piece has, shape (p,).
        near: below this way a place and the end of a stage are one.
        asked: room to work in, shape (k,).
        law: likewise, shape (4, k).
        bands: where they go: place at the end, bounds of speed, acceleration and jerk, number of the piece,
            and time at the end since the start of the part [s], of shape (6, k + s).
        told: where their number goes, shape (1,).
    """
    inside, duration = 0, ends[ends.shape[0] - 1]
    for k in range(times.shape[0]):
        if 0.0 < times[k] - start < duration:
            asked[inside] = times[k] - start
            inside += 1
    rows_at(segments, duration, asked[:inside], law[:, :inside])
    count, k, begin, place = 0, 0, 0.0, 0.0
    piece, left = 0, counts[0]
    for stage in range(stages.shape[0]):
        end = begin + stages[stage, 0]
        if left == 0.0:
            piece += 1
            left = counts[piece]
        left -= 1.0
        until = inf if stage + 1 == stages.shape[0] else end
        while k < inside and begins[int(law[0, k])] + law[1, k] <= until:
            at = begins[int(law[0, k])] + law[1, k]
            k += 1
            if at > place and at - begin > near and end - at > near:
                bands[TIME, count] = asked[k - 1]
                count = _add(bands, count, at, stages, stage, piece)
                place = at
        time_at(segments, ends, piece, end - begins[piece], bands[TIME, count : count + 1])
        count = _add(bands, count, end, stages, stage, piece)
        place = begin = end
    told[0] = count


def _add(bands: Array, count: int, end: float, stages: Array, stage: int, piece: int) -> int:
    """Write a band but for the time at its end; return the number of all."""
    bands[0, count], bands[PIECE, count] = end, piece
    for kind in range(1, 4):
        bands[kind, count] = stages[stage, kind]
    return count + 1
