"""Path accuracy of the straight moves, in the words of ISO 9283.

A simulated run attains each move once, so the path error of a sample stands where ISO 9283 has the
barycentre of several cycles: the largest one is the path accuracy AT_p of that single cycle. Path
velocity accuracy AV = (mean attained speed - command speed) / command speed; both speeds are taken
over the middle half of the time in which the commanded speed is within 1 % of its largest value.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ropsim.flow import MoveEvent, Recording
from ropsim.spatial import Array
from ropsim.views.channels import StationView, rms, station_views

Indices = npt.NDArray[np.intp]

PLATEAU = 0.99
"""Share of the largest commanded speed from which on a sample belongs to the plateau."""

STANDSTILL = 1e-6
"""Commanded speed below which a move has no plateau [m/s]."""


@dataclass(frozen=True, slots=True)
class PathMove:
    """One straight move.

    Attributes:
        station: whose move it is.
        ordinal: of the move in its station.
        line: source line, 0 where unknown.
        visit: loop pass, 0 where unknown.
        time: when the largest error occurred [s].
        max_error: largest distance of the attained TCP from the commanded line [m].
        rms_error: root of the mean square of that distance [m].
        command_speed: mean commanded speed on the plateau [m/s]; NaN without a plateau.
        speed_accuracy: AV, a share; NaN without a plateau.
    """

    station: str
    ordinal: int
    line: int
    visit: int
    time: float
    max_error: float
    rms_error: float
    command_speed: float
    speed_accuracy: float


@dataclass(frozen=True, slots=True)
class PathLine:
    """All straight moves of one source line.

    Attributes:
        station: whose program has it.
        line: source line, 0 where unknown.
        moves: in order of time.
    """

    station: str
    line: int
    moves: tuple[PathMove, ...]

    @property
    def worst(self) -> PathMove:
        """Return the move with the largest error."""
        return max(self.moves, key=lambda move: move.max_error)

    @property
    def rms_error(self) -> float:
        """Return the root of the mean of the squared RMS errors of the moves [m]."""
        return math.sqrt(sum(move.rms_error**2 for move in self.moves) / len(self.moves))

    @property
    def worst_speed(self) -> PathMove | None:
        """Return the move whose AV is the largest in magnitude, None where no move has one."""
        return largest_speed_error(self.moves)


@dataclass(frozen=True, slots=True)
class PathSummary:
    """The straight moves of a run.

    Attributes:
        moves: in order of time; empty where the run has none.
        mean_error: mean distance from the commanded line over all samples of LIN moves [m].
        rms_error: root of its mean square [m].
        p95_error: its 95th percentile [m].
    """

    moves: tuple[PathMove, ...] = ()
    mean_error: float = math.nan
    rms_error: float = math.nan
    p95_error: float = math.nan

    @property
    def worst(self) -> PathMove | None:
        """Return the move with the largest error, None where there is no straight move."""
        return max(self.moves, key=lambda move: move.max_error, default=None)

    @property
    def max_error(self) -> float:
        """Return the largest distance from the commanded line [m]; NaN where there is none."""
        return self.worst.max_error if self.worst else math.nan

    @property
    def worst_speed(self) -> PathMove | None:
        """Return the move whose AV is the largest in magnitude, None where no move has one."""
        return largest_speed_error(self.moves)

    @property
    def mean_speed_accuracy(self) -> float:
        """Return the mean AV of the moves that have one, a share; NaN where none has."""
        known = [move.speed_accuracy for move in self.moves if math.isfinite(move.speed_accuracy)]
        return sum(known) / len(known) if known else math.nan

    @property
    def lines(self) -> tuple[PathLine, ...]:
        """Return the moves by source line, in the order of stations and lines."""
        places = sorted({(move.station, move.line) for move in self.moves})
        return tuple(
            PathLine(*place, tuple(move for move in self.moves if (move.station, move.line) == place))
            for place in places
        )


def largest_speed_error(moves: tuple[PathMove, ...]) -> PathMove | None:
    """Return the move whose AV is the largest in magnitude, None where no move has one."""
    known = [move for move in moves if math.isfinite(move.speed_accuracy)]
    return max(known, key=lambda move: abs(move.speed_accuracy), default=None)


def summarize_path(recording: Recording) -> PathSummary:
    """Return the accuracy of all moves for which the recording has a path error, in order of time."""
    stations = [(station, station.series("path_error")) for station in station_views(recording)]
    known = np.concatenate([error[np.isfinite(error)] for _, error in stations] or [np.empty(0)])
    if known.size == 0:
        return PathSummary()
    moves = [move for station, error in stations for move in _moves(station, error)]
    return PathSummary(
        moves=tuple(sorted(moves, key=lambda move: move.time)),
        mean_error=float(np.mean(known)),
        rms_error=rms(known),
        p95_error=float(np.percentile(known, 95.0)),
    )


def speed(station: StationView, quantity: str) -> Array:
    """Return the speed of a position [m/s], shape (n,), by central differences."""
    position = station.matrix(quantity, 3)
    if station.time.shape[0] < 2:
        return np.full(station.time.shape, np.nan)
    rate = np.gradient(position, station.time, axis=0)
    return np.asarray(np.linalg.norm(rate, axis=1), dtype=np.float64)


def path_speed(station: StationView, kind: str) -> Array:
    """Return the speed of the TCP against the frame of its path [m/s], shape (n,): mostly the base frame.

    Args:
        station: whose TCP it is.
        kind: `command` or `attained`.
    """
    carried = station.series(f"{kind}_path_speed")
    return np.where(np.isfinite(carried), carried, speed(station, f"{kind}_position"))


def _moves(station: StationView, error: Array) -> Iterator[PathMove]:
    """Yield the straight moves of a station; `error` are its path errors, shape (n,)."""
    inside = np.flatnonzero(np.isfinite(error))
    ordinals, visits = station.ordinals(), _visits(station)
    command, attained = path_speed(station, "command"), path_speed(station, "attained")
    for piece in np.split(inside, np.flatnonzero(np.diff(ordinals[inside]) != 0) + 1):
        if piece.size:
            ordinal = int(ordinals[piece[0]])
            accuracy = _speed_accuracy(command[piece], attained[piece])
            yield _move(station, piece, error, accuracy, ordinal, visits.get(ordinal, 0))


def _move(
    station: StationView,
    piece: Indices,
    error: Array,
    speed_accuracy: tuple[float, float],
    ordinal: int,
    visit: int,
) -> PathMove:
    """Return the figures of the samples `piece`."""
    worst = int(piece[np.argmax(error[piece])])
    time, line = float(station.time[worst]), station.line(worst)
    return PathMove(
        station.facts.name,
        ordinal,
        line,
        visit,
        time,
        float(error[worst]),
        rms(error[piece]),
        *speed_accuracy,
    )


def _speed_accuracy(command: Array, attained: Array) -> tuple[float, float]:
    if not np.any(np.isfinite(command)) or float(np.nanmax(command)) < STANDSTILL:
        return math.nan, math.nan
    plateau = np.flatnonzero(command >= PLATEAU * np.nanmax(command))
    quarter = plateau.size // 4
    middle = plateau[quarter : plateau.size - quarter]
    command_speed = float(np.mean(command[middle]))
    return command_speed, float(np.mean(attained[middle])) / command_speed - 1.0


def _visits(station: StationView) -> dict[int, int]:
    """Return the loop pass of each move of a station, by its ordinal."""
    return {
        event.ordinal: event.visit
        for event in station.recording.events
        if isinstance(event, MoveEvent) and event.station == station.facts.name
    }
