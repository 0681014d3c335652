"""Motion time over real time, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[::1], f8[::1], f8[::1], f8[::1], f8[::1], f8[:,::1])")
def motion_time_at(
    knots: Array, places: Array, rates: Array, changes: Array, times: Array, out: Array
) -> None:
    """Write motion time [s], its rate and the change of that [1/s] at real times; see `MotionTime.at`.

    Args:
        knots: real times of the knots [s], rising, shape (m,), m >= 2.
        places: motion times there [s], shape (m,).
        rates: there, shape (m,).
        changes: of the rates there [1/s], shape (m,).
        times: real times [s], best in order, shape (k,).
        out: where the answers go, shape (3, k).
    """
    last, i = knots.shape[0] - 1, 0
    for k in range(times.shape[0]):
        t = min(max(times[k], knots[0]), knots[last])
        if t < knots[i]:
            i = 0
        while i < last - 1 and knots[i + 1] <= t:
            i += 1
        past, step = t - knots[i], knots[i + 1] - knots[i]
        first, change, end = rates[i], changes[i], changes[i + 1]
        more = (rates[i + 1] - first) / step
        square = (3.0 * more - 2.0 * change - end) / step
        cube = (change + end - 2.0 * more) / (step * step)
        way = past * (first + past * (change / 2.0 + past * (square / 3.0 + past * cube / 4.0)))
        phi = min(max(places[i] + way, places[i]), places[i + 1])
        out[0, k] = phi if t < knots[last] else places[last]
        out[1, k] = first + past * (change + past * (square + past * cube))
        out[2, k] = change + past * (2.0 * square + past * 3.0 * cube)
