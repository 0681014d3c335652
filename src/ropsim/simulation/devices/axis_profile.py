"""Motion profile of one axis over time: segments of constant acceleration, known in closed form."""

import math
from bisect import bisect_right
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from ropsim.spatial import Array


class ProfileSegment(NamedTuple):
    """From a time on.

    Attributes:
        time: [s].
        q: coordinate there [rad | m].
        qd: speed there.
        qdd: acceleration from there on.
    """

    time: float
    q: float
    qd: float
    qdd: float

    def at(self, time: float) -> tuple[float, float]:
        """Return coordinate and speed at a time."""
        t = time - self.time
        return self.q + t * (self.qd + 0.5 * self.qdd * t), self.qd + self.qdd * t


@dataclass(slots=True)
class AxisProfile:
    """Pieces in order of time; the last one holds for ever."""

    segments: list[ProfileSegment] = field(default_factory=lambda: [ProfileSegment(0.0, 0.0, 0.0, 0.0)])

    def at(self, time: float) -> tuple[float, float]:
        """Return coordinate [rad | m] and speed at a time [s]."""
        place = bisect_right(self.segments, time, key=lambda segment: segment.time) - 1
        return self.segments[max(place, 0)].at(time)

    def rows(self, times: Array) -> Array:
        """Return the coordinates at many times [s], shape as `times`."""
        table = np.array(self.segments)
        segment = table[np.maximum(np.searchsorted(table[:, 0], times, side="right") - 1, 0)]
        t = times - segment[:, 0]
        return np.asarray(segment[:, 1] + t * (segment[:, 2] + 0.5 * segment[:, 3] * t))

    def go(self, segments: list[ProfileSegment]) -> None:
        """Go on otherwise from the time of the first of some pieces."""
        while self.segments and self.segments[-1].time >= segments[0].time:
            self.segments.pop()
        self.segments += segments

    def time_of(self, q: float, since: float) -> float:
        """Return when the coordinate grows to a value, from the piece in force at a time on [s], or inf."""
        first = max(bisect_right(self.segments, since, key=lambda segment: segment.time) - 1, 0)
        segments = self.segments[first:]
        for segment, end in zip(segments, [*(one.time for one in segments[1:]), math.inf], strict=True):
            found = _reached(segment, q)
            if found is not None and segment.time + found <= end:
                return segment.time + found
        return math.inf


def to_speed(time: float, q: float, qd: float, speed: float, acceleration: float) -> list[ProfileSegment]:
    """Return the pieces from a state to a constant speed.

    Args:
        time: when they begin [s].
        q: coordinate there [rad | m].
        qd: speed there.
        speed: in the end.
        acceleration: greatest one, above 0.
    """
    if qd == speed:
        return [ProfileSegment(time, q, qd, 0.0)]
    rise = ProfileSegment(time, q, qd, math.copysign(acceleration, speed - qd))
    end = time + abs(speed - qd) / acceleration
    return [rise, ProfileSegment(end, rise.at(end)[0], speed, 0.0)]


def to_rest(
    time: float, q: float, qd: float, target: float, speed: float, acceleration: float
) -> list[ProfileSegment]:
    """Return the pieces from a state to rest at a target in the shortest time.

    Args:
        time: when they begin [s].
        q: coordinate there [rad | m].
        qd: speed there.
        target: where it is to stand in the end [rad | m].
        speed: greatest one, above 0.
        acceleration: greatest one, above 0.
    """
    brake = qd * abs(qd) / (2.0 * acceleration)
    sign = math.copysign(1.0, target - (q + brake))
    distance, start = sign * (target - q), sign * qd
    # `way` is at least the way of braking: from above `speed` the peak is `speed`, and it slows down first
    peak = min(speed, math.sqrt(max(acceleration * distance + 0.5 * start * start, 0.0)))
    rise = abs(peak - start) / acceleration
    change = math.copysign(1.0, peak - start)
    cruise = distance - (change * (peak * peak - start * start) + peak * peak) / (2.0 * acceleration)
    segments = [ProfileSegment(time, q, qd, sign * change * acceleration)] if rise else []
    begin = time + rise
    middle = segments[-1].at(begin)[0] if segments else q
    long = max(cruise / peak, 0.0) if peak else 0.0
    if long:
        segments.append(ProfileSegment(begin, middle, sign * peak, 0.0))
        begin, middle = begin + long, middle + sign * peak * long
    if peak:
        segments.append(ProfileSegment(begin, middle, sign * peak, -sign * acceleration))
    return [*segments, ProfileSegment(begin + peak / acceleration, target, 0.0, 0.0)]


def _reached(segment: ProfileSegment, q: float) -> float | None:
    """Return how long after its beginning a piece comes to a coordinate from below [s], None for never."""
    distance = q - segment.q
    if distance < 0.0 or (segment.qd <= 0.0 and segment.qdd <= 0.0):
        return None
    root = segment.qd * segment.qd + 2.0 * segment.qdd * distance
    if root < 0.0:
        return None
    return 2.0 * distance / (segment.qd + math.sqrt(root)) if distance else 0.0
