"""Control ticks at which limits are exceeded, and what a motion does there, in loops for numba."""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion import rows_at
from ropsim.spatial import Array


@kernel
def exceeding(used: Array2, allowed: float, phi: Array1, spans: Array2, ticks: Array1, told: Array2) -> None:
    """Write the ticks, without 0, at which a limit is exceeded, and which of them lie in spans.

    Args:
        used: of the limits, shape (4, k).
        allowed: what may be used, 1 and rounding.
        phi: motion times of the ticks, rising [s], shape (k,).
        spans: motion times behind which a span begins and up to which it goes [s], shape (r, 2 or more).
        ticks: where the numbers of the ticks go, shape (k,).
        told: where the first one in each span and that behind the last one go, as places in `ticks`, (r, 2).
    """
    count = 0
    for k in range(1, phi.shape[0]):
        if max(used[0, k], used[1, k], used[2, k], used[3, k]) > allowed:
            ticks[count] = k
            count += 1
    for span in range(spans.shape[0]):
        for end in range(2):
            low, high = 0, count
            while low < high:
                middle = (low + high) // 2
                if phi[int(ticks[middle])] <= spans[span, end]:
                    low = middle + 1
                else:
                    high = middle
            told[span, end] = low


@kernel
def walk_at(
    segments: Array2,
    duration: float,
    start: float,
    begins: Array1,
    phi: Array1,
    ticks: Array1,
    q: Array2,
    qd: Array2,
    qdd: Array2,
    times: Array1,
    law: Array2,
    places: Array2,
    motion: Array3,
    changed: Array3,
) -> None:
    """Write where a run is at ticks and at those before them, and what joints do there.

    Args:
        segments: of its time law, see `TimeLaw`, shape (8, m).
        duration: of it [s].
        start: motion time at which it begins [s].
        begins: places at which its pieces begin, shape (p or more,).
        phi: motion times of all ticks, rising [s], shape (k,).
        ticks: numbers of b of them, none of them 0, shape (b,).
        q: joint coordinates at all ticks [rad | m], shape (k, n).
        qd: speeds [rad/s | m/s], likewise.
        qdd: accelerations [rad/s² | m/s²], likewise.
        times: room to work in, shape (2·b,).
        law: where rows of the time law go, those of the ticks before first, and below them the jerk behind
            each of these times, shape (5, 2·b).
        places: where places on the whole run go, shape (2, b).
        motion: where coordinates and speeds at the ticks go, shape (2, b, n).
        changed: where accelerations at the ticks before and at the ticks go, shape (2, b, n).
    """
    b = ticks.shape[0]
    for k in range(b):
        tick = int(ticks[k])
        times[k], times[b + k] = phi[tick - 1] - start, phi[tick] - start
        for j in range(q.shape[1]):
            motion[0, k, j], motion[1, k, j] = q[tick, j], qd[tick, j]
            changed[0, k, j], changed[1, k, j] = qdd[tick - 1, j], qdd[tick, j]
    rows_at(segments, duration, times, law)
    _jerks_at(segments, duration, times, law[4])
    for k in range(b):
        places[0, k] = begins[int(law[0, k])] + law[1, k]
        places[1, k] = begins[int(law[0, b + k])] + law[1, b + k]


def _jerks_at(segments: Array, duration: float, times: Array, jerks: Array) -> None:
    """Write the jerk behind each time, 0 outside of the motion."""
    row, last = 0, segments.shape[1] - 1
    for k in range(times.shape[0]):
        while row > 0 and segments[1, row] > times[k]:
            row -= 1
        while row < last and segments[1, row + 1] <= times[k]:
            row += 1
        jerks[k] = segments[5, row] if 0.0 <= times[k] < duration else 0.0
