"""Where a trace stands: the places between which the robot moves."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.calibration.trace.time_stamps import time_noise
from ropsim.calibration.trace.trace import Trace
from ropsim.spatial import Array, frozen, record

SMOOTHING = 0.016
"""Half of the time over which speeds are taken [s]."""

_VALLEY = 8.0
"""How many times faster the robot is before and behind a stop than in it."""
_NOISE = 3.0
"""Speeds up to this multiple of the noise count as zero."""
_LOUDEST = 1e-3
"""Largest speed of the noise of an axis, as a share of the speed that counts as its largest."""
_LEAST_SPEED = 1e-4
"""Share of the largest speed of an axis up to which it stands."""
_LEAST_STEP = 0.02
"""Quantile of the steps of an axis that moves that counts as the least one."""
_STILL = 4
"""Samples beyond the first one of a stop of which the noise is known."""
_COARSEST = 2e-3
"""Largest step of an encoder that is believed [rad | m]."""


@record
class Rests:
    """Stops, in order of time.

    Attributes:
        spans: numbers of the first and of the last sample of each, m of them.
        q: where it is [rad | m], shape (m, n).
        noise: of each axis at rest [rad | m], shape (n,).
        time_noise: standard deviation of the times of samples from those they name [s].
        still_noise: of all axes while they stand, where wrong times do nothing [rad | m].
    """

    spans: tuple[tuple[int, int], ...]
    q: Array
    noise: Array
    time_noise: float = 0.0
    still_noise: float = 0.0

    def __post_init__(self) -> None:
        for name in ("q", "noise"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    @property
    def count(self) -> int:
        """Return how many there are."""
        return len(self.spans)


def rests_of(trace: Trace) -> Rests:
    """Return the stops of a trace: its ends, and the valleys of its speed.

    The speed is that of the axis that is nearest to its own largest one. A valley is a stop where the robot
    is much faster before and behind it, so that stops of a single sample are found between quick moves, and
    slow moves between long ones. A robot that only slows down causes an additional stop; comparison with the
    program removes it.

    Args:
        trace: of n axes.
    """
    noise = _noise(trace.q)
    speeds, floor = _speeds(trace, noise)
    spans = _valleys(speeds, floor)
    q = np.array([trace.q[first : last + 1].mean(axis=0) for first, last in spans])
    return Rests(tuple(spans), q, noise, time_noise(trace), _still_noise(trace, spans, q))


def _noise(q: Array) -> Array:
    """Return the step of the encoder of each axis, or its noise where that is more [rad | m], shape (n,)."""
    steps = np.abs(np.diff(q, axis=0))
    found = [min(_step(column), _COARSEST) for column in steps.T]
    bends = np.quantile(np.abs(np.diff(q, n=2, axis=0)), 0.2, axis=0)
    return np.asarray(np.maximum(np.array(found), np.minimum(bends, _COARSEST)))


def _step(steps: Array) -> float:
    """Return the least step of an axis that moves [rad | m]."""
    moving = steps[steps > 1e-12]
    return float(np.quantile(moving, _LEAST_STEP)) if moving.size else 0.0


def _still_noise(trace: Trace, spans: Sequence[tuple[int, int]], q: Array) -> float:
    """Return the step of the encoders, or how much axes differ from a stop while they stand if that is more.

    Args:
        trace: of n axes.
        spans: first and last sample of each stop, m of them.
        q: where it is [rad | m], shape (m, n).
    """
    step = max(_step(column) for column in np.abs(np.diff(trace.q, axis=0)).T)
    apart = [
        np.sqrt(np.mean((trace.q[first : last + 1] - place) ** 2, axis=0)).max()
        for (first, last), place in zip(spans, q, strict=True)
        if last - first >= _STILL
    ]
    return min(max(step, float(np.median(apart)) if apart else 0.0), _COARSEST)


def _speeds(trace: Trace, noise: Array) -> tuple[Array, float]:
    """Return the speed at each sample as a share of the largest one, shape (k,), and that of noise."""
    around = max(1, round(SMOOTHING / trace.period))
    number = np.arange(len(trace.time))
    before, behind = np.maximum(number - around, 0), np.minimum(number + around, len(number) - 1)
    spans = (trace.time[behind] - trace.time[before])[:, None]
    speeds = np.abs(trace.q[behind] - trace.q[before]) / spans
    of_noise = noise / (2.0 * around * trace.period)
    largest = np.maximum(speeds.max(axis=0), of_noise / _LOUDEST + 1e-9)
    floor = max(_NOISE * float((of_noise / largest).max()), _LEAST_SPEED)
    return np.asarray((speeds / largest).max(axis=1)), floor


def _valleys(speeds: Array, floor: float) -> list[tuple[int, int]]:
    """Return first and last sample of each valley; the trace begins and ends with one."""
    slow = np.flatnonzero(speeds <= floor)
    spans: list[tuple[int, int]] = []
    least, top, at, in_valley = np.inf, 0.0, 0, True
    bottoms: list[int] = []
    for number, speed in enumerate(np.maximum(speeds, floor).tolist()):
        if in_valley:
            if speed < least:
                least, at = speed, number
            if speed > _VALLEY * least:
                bottoms.append(at)
                in_valley, top = False, speed
        else:
            top = max(top, speed)
            if speed < top / _VALLEY:
                in_valley, least, at = True, speed, number
    bottoms.append(at if in_valley else len(speeds) - 1)
    for bottom in bottoms:
        if speeds[bottom] > floor:
            spans.append((bottom, bottom))
            continue
        place = int(np.searchsorted(slow, bottom))
        spans.append(_run(slow, place))
    return spans


def _run(slow: npt.NDArray[np.intp], place: int) -> tuple[int, int]:
    """Return first and last of the numbers that follow one another around a place of a rising list."""
    low = high = place
    while low > 0 and slow[low - 1] == slow[low] - 1:
        low -= 1
    while high + 1 < len(slow) and slow[high + 1] == slow[high] + 1:
        high += 1
    return int(slow[low]), int(slow[high])
