"""Times of the parts of a path, of its tool and of its joints, in plain loops that numba compiles."""

from math import sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array


@kernel
def part_times(
    d1: Array2,
    q: Array2,
    step: float,
    speed: float,
    turning: float,
    max_speeds: Array1,
    own: Array1,
    joint_times: Array2,
    result: Array1,
) -> None:
    """Write the times that a tool and its joints take at least for the parts between places of a path.

    Args:
        d1: first derivatives of the tool at the places, shape (k + 1, 6).
        q: joint coordinates there [rad | m], shape (k + 1, n).
        step: from one place to the next.
        speed: of the TCP [m/s].
        turning: angular speed of the tool [rad/s].
        max_speeds: of the joints [rad/s | m/s], shape (n,).
        own: where the times of the tool go [s], shape (k,).
        joint_times: output for the times of the joints [s], shape (k, n).
        result: set to the least share of its own time to that of its slowest joint, at most 1, shape (1,).
    """
    result[0] = 1.0
    before = _slowness(d1, 0, speed, turning)
    for k in range(own.shape[0]):
        behind = _slowness(d1, k + 1, speed, turning)
        own[k], before = step * max(before, behind), behind
        longest = own[k]
        for j in range(q.shape[1]):
            joint_times[k, j] = abs(q[k + 1, j] - q[k, j]) / max_speeds[j]
            longest = max(longest, joint_times[k, j])
        if own[k] < result[0] * longest:
            result[0] = own[k] / longest


@kernel
def longest_cell(
    q: Array2, derivatives: Array3, parameters: Array1, max_speeds: Array1, result: Array1
) -> None:
    """Write a time that no joint needs more than for a unit of the path parameter, at its pace anywhere.

    The first derivative of the polynomial between two rows is nowhere beyond its Bernstein coefficients.

    Args:
        q: joint coordinates at the rows [rad | m], shape (k, n).
        derivatives: first and second ones by the path parameter, shape (2, k, n).
        parameters: path parameters of the rows, shape (k,).
        max_speeds: of the joints [rad/s | m/s], shape (n,).
        result: output for the time [s by unit], shape (1,).
    """
    result[0] = 0.0
    for k in range(q.shape[0] - 1):
        step = parameters[k + 1] - parameters[k]
        for j in range(q.shape[1]):
            v, w = derivatives[0, k, j], derivatives[0, k + 1, j]
            bend = 0.25 * step
            first, last = v + bend * derivatives[1, k, j], w - bend * derivatives[1, k + 1, j]
            middle = 5.0 * (q[k + 1, j] - q[k, j]) / step - (v + first + last + w)
            most = max(abs(v), abs(w), abs(first), abs(last), abs(middle))
            result[0] = max(result[0], most / max_speeds[j])


def _slowness(d1: Array, k: int, speed: float, turning: float) -> float:
    """Return the time for a unit of the place."""
    x, y, z, a, b, c = d1[k, 0], d1[k, 1], d1[k, 2], d1[k, 3], d1[k, 4], d1[k, 5]
    return max(sqrt(x * x + y * y + z * z) / speed, sqrt(a * a + b * b + c * c) / turning)
