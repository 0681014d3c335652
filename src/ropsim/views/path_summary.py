"""Path accuracy of the straight moves, in the words of ISO 9283.

A simulated run attains each move once, so the path error of a sample stands where ISO 9283 has the
barycentre of several cycles: the largest one is the path accuracy AT_p of that single cycle. Path
velocity accuracy AV = (mean attained speed - command speed) / command speed; both speeds are taken
over the middle half of the time in which the commanded speed is within 1 % of its largest value.
"""

import math
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from ropsim.flow import Recording
from ropsim.spatial import Array
from ropsim.views.channels import codes, line_at, matrix, rms, series
from ropsim.views.header import whole

Indices = npt.NDArray[np.intp]

PLATEAU = 0.99
"""Share of the largest commanded speed from which on a sample belongs to the plateau."""

STANDSTILL = 1e-6
"""Commanded speed below which a move has no plateau [m/s]."""


@dataclass(frozen=True, slots=True)
class PathMove:
    """One straight move.

    Attributes:
        ordinal: of the move in the run.
        line: source line, 0 where unknown.
        visit: loop pass, 0 where unknown.
        time: when the largest error occurred [s].
        max_error: largest distance of the attained TCP from the commanded line [m].
        rms_error: root of the mean square of that distance [m].
        command_speed: mean commanded speed on the plateau [m/s]; NaN without a plateau.
        speed_accuracy: AV, a share; NaN without a plateau.
    """

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
        line: source line, 0 where unknown.
        moves: in order of time.
    """

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
        """Return the moves by source line, in the order of the lines."""
        numbers = sorted({move.line for move in self.moves})
        return tuple(
            PathLine(line, tuple(move for move in self.moves if move.line == line)) for line in numbers
        )


def largest_speed_error(moves: tuple[PathMove, ...]) -> PathMove | None:
    """Return the move whose AV is the largest in magnitude, None where no move has one."""
    known = [move for move in moves if math.isfinite(move.speed_accuracy)]
    return max(known, key=lambda move: abs(move.speed_accuracy), default=None)


def summarize_path(recording: Recording) -> PathSummary:
    """Return the accuracy of all moves for which the recording has a path error."""
    error = series(recording, "path_error")
    inside = np.flatnonzero(np.isfinite(error))
    if inside.size == 0:
        return PathSummary()
    ordinals = codes(recording, "move", -1)
    speeds = speed(recording, "command_position"), speed(recording, "attained_position")
    visits = _visits(recording)
    pieces = np.split(inside, np.flatnonzero(np.diff(ordinals[inside]) != 0) + 1)
    known = error[inside]
    return PathSummary(
        moves=tuple(
            replace(
                _move(recording, piece, error, _speed_accuracy(speeds[0][piece], speeds[1][piece])),
                ordinal=int(ordinals[piece[0]]),
                visit=visits.get(int(ordinals[piece[0]]), 0),
            )
            for piece in pieces
        ),
        mean_error=float(np.mean(known)),
        rms_error=rms(known),
        p95_error=float(np.percentile(known, 95.0)),
    )


def speed(recording: Recording, channel: str) -> Array:
    """Return the speed of a position channel [m/s], shape (n,), by central differences."""
    position = matrix(recording, channel, 3)
    if recording.time.shape[0] < 2:
        return np.full(recording.time.shape, np.nan)
    rate = np.gradient(position, recording.time, axis=0)
    return np.asarray(np.linalg.norm(rate, axis=1), dtype=np.float64)


def _move(
    recording: Recording, piece: Indices, error: Array, speed_accuracy: tuple[float, float]
) -> PathMove:
    """Return the figures of the samples `piece`; ordinal and visit are left open."""
    worst = int(piece[np.argmax(error[piece])])
    time, line = float(recording.time[worst]), line_at(recording, worst)
    return PathMove(-1, line, 0, time, float(error[worst]), rms(error[piece]), *speed_accuracy)


def _speed_accuracy(command: Array, attained: Array) -> tuple[float, float]:
    if not np.any(np.isfinite(command)) or float(np.nanmax(command)) < STANDSTILL:
        return math.nan, math.nan
    plateau = np.flatnonzero(command >= PLATEAU * np.nanmax(command))
    quarter = plateau.size // 4
    middle = plateau[quarter : plateau.size - quarter]
    command_speed = float(np.mean(command[middle]))
    return command_speed, float(np.mean(attained[middle])) / command_speed - 1.0


def _visits(recording: Recording) -> dict[int, int]:
    return {
        whole(event.data.get("ordinal"), -1): whole(event.data.get("visit"), 0)
        for event in recording.events
        if event.kind == "move"
    }
