"""Poses of the mechanical interface along a path of the tool, as dense as way and turn ask, in loops."""

from math import ceil, sqrt

from ropsim.codegen import kernel
from ropsim.controller.interpolator import FEWEST, LOOKS
from ropsim.motion import curve_points, curve_poses, straight_points
from ropsim.spatial import Array

_MANY = 1e7
"""So many steps are a mistake."""


@kernel("void(f8, f8, f8[:,::1], i8, f8, f8[::1], f8[::1], f8[:,:,::1], f8[:,:,::1], f8[::1])")
def line_samples(
    way: float,
    turn: float,
    X_TM: Array,
    density: int,
    length: float,
    numbers: Array,
    s: Array,
    rates: Array,
    T: Array,
    told: Array,
) -> None:
    """Write X_BM at equally spaced places of a line, as `StandardInterpolator` samples it.

    Args:
        way: longest way of the TCP between two samples [m].
        turn: largest turn of the tool between two samples [rad].
        X_TM: of the tool, shape (4, 4).
        density: how many times more samples than at first, at least; twice as many where their number would
            be even.
        length: of the path.
        numbers: of the line, as `straight_points` takes them.
        s: room for places, shape (most,), most > LOOKS.
        rates: room for derivatives, shape (2, most, 6).
        T: where the poses go, shape (most, 4, 4).
        told: becomes the number of poses and the density; nothing is written of more poses than there is
            room for, or where the number is 0, of ways that have no number of steps; shape (2,).
    """
    _places(length, LOOKS, s)
    straight_points(numbers, s[: LOOKS + 1], T[: LOOKS + 1], rates[0][: LOOKS + 1], rates[1][: LOOKS + 1])
    count = _count(length, way, turn, rates[0], density, told)
    if 0 < count <= T.shape[0]:
        _places(length, count - 1, s)
        straight_points(numbers, s[:count], T[:count], rates[0][:count], rates[1][:count])
        _to_interface(T, count, X_TM)


@kernel(
    "void(f8, f8, f8[:,::1], i8, f8, f8[:,::1], f8[::1], f8[:,::1], i8, f8[:,:,::1], f8[:,:,::1],"
    " f8[::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def curve_samples(
    way: float,
    turn: float,
    X_TM: Array,
    density: int,
    length: float,
    series: Array,
    ends: Array,
    inverse: Array,
    steps: int,
    coefficients: Array,
    middles: Array,
    s: Array,
    rates: Array,
    T: Array,
    told: Array,
) -> None:
    """Write X_BM at equally spaced places of a curve, as `line_samples` does of a line.

    Args:
        way: as for `line_samples`, as all that are not named here.
        turn: see there.
        X_TM: see there.
        density: see there.
        length: see there.
        series: of the curve, as `curve_points` takes it.
        ends: likewise.
        inverse: likewise.
        steps: likewise.
        coefficients: likewise.
        middles: likewise.
        s: see there.
        rates: see there.
        T: see there.
        told: see there.
    """
    looks = LOOKS + 1
    _places(length, LOOKS, s)
    curve_points(
        series, ends, inverse, steps, coefficients, middles,
        s[:looks], T[:looks], rates[0][:looks], rates[1][:looks],
    )  # fmt: skip
    count = _count(length, way, turn, rates[0], density, told)
    if 0 < count <= T.shape[0]:
        _places(length, count - 1, s)
        curve_poses(series, ends, inverse, steps, coefficients, middles, s[:count], T[:count])
        _to_interface(T, count, X_TM)


def _places(length: float, steps: int, s: Array) -> None:
    """Write the places between equal steps, as `interpolator.places` does."""
    step = length / steps
    for k in range(steps):
        s[k] = k * step
    s[steps] = length


def _count(length: float, way: float, turn: float, d1: Array, density: int, told: Array) -> int:
    """Return the number of samples of a path that was looked at; write it and the density."""
    moved = turned = 0.0
    for k in range(LOOKS + 1):
        moved = max(moved, d1[k, 0] * d1[k, 0] + d1[k, 1] * d1[k, 1] + d1[k, 2] * d1[k, 2])
        turned = max(turned, d1[k, 3] * d1[k, 3] + d1[k, 4] * d1[k, 4] + d1[k, 5] * d1[k, 5])
    wanted = max(sqrt(moved) * length / way, sqrt(turned) * length / turn)
    told[0], told[1] = 0.0, 0.0
    if not wanted < _MANY:
        return 0
    steps = max(FEWEST, ceil(wanted))
    times = 2 if steps % 2 == 1 and density == 1 else density
    count = steps * times + 1
    told[0], told[1] = count, times
    return count


def _to_interface(T: Array, count: int, X_TM: Array) -> None:
    """Make X_BM of X_BT."""
    for k in range(count):
        for i in range(3):
            a, b, c = T[k, i, 0], T[k, i, 1], T[k, i, 2]
            for j in range(3):
                T[k, i, j] = a * X_TM[0, j] + b * X_TM[1, j] + c * X_TM[2, j]
            T[k, i, 3] += a * X_TM[0, 3] + b * X_TM[1, 3] + c * X_TM[2, 3]
