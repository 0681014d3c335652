"""The course of one axis over time: pieces of constant acceleration, known in closed form."""

import math
from bisect import bisect_right
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from ropsim.spatial import Array


class Piece(NamedTuple):
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
class Course:
    """Pieces in order of time; the last one holds for ever."""

    pieces: list[Piece] = field(default_factory=lambda: [Piece(0.0, 0.0, 0.0, 0.0)])

    def at(self, time: float) -> tuple[float, float]:
        """Return coordinate [rad | m] and speed at a time [s]."""
        place = bisect_right(self.pieces, time, key=lambda piece: piece.time) - 1
        return self.pieces[max(place, 0)].at(time)

    def rows(self, times: Array) -> Array:
        """Return the coordinates at many times [s], shape as `times`."""
        table = np.array(self.pieces)
        piece = table[np.maximum(np.searchsorted(table[:, 0], times, side="right") - 1, 0)]
        t = times - piece[:, 0]
        return np.asarray(piece[:, 1] + t * (piece[:, 2] + 0.5 * piece[:, 3] * t))

    def go(self, pieces: list[Piece]) -> None:
        """Go on otherwise from the time of the first of some pieces."""
        while self.pieces and self.pieces[-1].time >= pieces[0].time:
            self.pieces.pop()
        self.pieces += pieces

    def time_of(self, q: float, since: float) -> float:
        """Return when the coordinate grows to a value, from the piece in force at a time on [s], or inf."""
        first = max(bisect_right(self.pieces, since, key=lambda piece: piece.time) - 1, 0)
        pieces = self.pieces[first:]
        for piece, end in zip(pieces, [*(one.time for one in pieces[1:]), math.inf], strict=True):
            found = _reached(piece, q)
            if found is not None and piece.time + found <= end:
                return piece.time + found
        return math.inf


def to_speed(time: float, q: float, qd: float, speed: float, acceleration: float) -> list[Piece]:
    """Return the pieces from a state to a constant speed.

    Args:
        time: when they begin [s].
        q: coordinate there [rad | m].
        qd: speed there.
        speed: in the end.
        acceleration: greatest one, above 0.
    """
    if qd == speed:
        return [Piece(time, q, qd, 0.0)]
    rise = Piece(time, q, qd, math.copysign(acceleration, speed - qd))
    end = time + abs(speed - qd) / acceleration
    return [rise, Piece(end, rise.at(end)[0], speed, 0.0)]


def to_rest(
    time: float, q: float, qd: float, target: float, speed: float, acceleration: float
) -> list[Piece]:
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
    way, start = sign * (target - q), sign * qd
    # `way` is at least the way of braking: from above `speed` the peak is `speed`, and it slows down first
    peak = min(speed, math.sqrt(max(acceleration * way + 0.5 * start * start, 0.0)))
    rise = abs(peak - start) / acceleration
    change = math.copysign(1.0, peak - start)
    cruise = way - (change * (peak * peak - start * start) + peak * peak) / (2.0 * acceleration)
    pieces = [Piece(time, q, qd, sign * change * acceleration)] if rise else []
    begin = time + rise
    middle = pieces[-1].at(begin)[0] if pieces else q
    long = max(cruise / peak, 0.0) if peak else 0.0
    if long:
        pieces.append(Piece(begin, middle, sign * peak, 0.0))
        begin, middle = begin + long, middle + sign * peak * long
    if peak:
        pieces.append(Piece(begin, middle, sign * peak, -sign * acceleration))
    return [*pieces, Piece(begin + peak / acceleration, target, 0.0, 0.0)]


def _reached(piece: Piece, q: float) -> float | None:
    """Return how long after its beginning a piece comes to a coordinate from below [s], None for never."""
    way = q - piece.q
    if way < 0.0 or (piece.qd <= 0.0 and piece.qdd <= 0.0):
        return None
    root = piece.qd * piece.qd + 2.0 * piece.qdd * way
    if root < 0.0:
        return None
    return 2.0 * way / (piece.qd + math.sqrt(root)) if way else 0.0
