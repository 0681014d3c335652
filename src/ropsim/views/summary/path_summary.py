"""Accuracy of the moves with a path of the tool: lines, arcs, curves, corners.

A simulated run attains each move once, so the path error of a sample replaces that of the barycentre of
several cycles in the path accuracy AT_p of ISO 9283. The other figures are defined in `views/accuracy`.
"""

import math
from collections.abc import Iterator
from dataclasses import field, replace

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.flow import CriticalLimit, MoveEvent, ReachedSpeed, Recording
from ropsim.spatial import Array
from ropsim.views.accuracy import (
    AccuracyConditions,
    SpeedFigures,
    largest_angle,
    path_repeatability,
    speed_figures,
)
from ropsim.views.channels import StationView, rms, station_views

REACHED = 0.99
"""Share of a given speed from which on it is reached."""

NEAR = 1e-3
"""Distance from its target within which a command has arrived, in addition to the step of one sample [m]."""

Indices = npt.NDArray[np.intp]


@frozen_dataclass
class PathMove:
    """One move with a path of the tool.

    Attributes:
        station: whose move it is.
        ordinal: of the move in its station.
        line: source line, 0 where unknown.
        visit: loop pass, 0 where unknown.
        time: when the largest error occurred [s]; without drives when the move began.
        max_error: largest distance of the attained TCP from the path of the tool [m]; NaN without drives, as
            are all figures of the attained path: the arm is where its reference is.
        rms_error: root of the mean square of that distance [m].
        max_angle: largest angle between attained and commanded orientation at one place of the path [rad];
            NaN where it is not known.
        speeds: AV and FV.
        given: path speed of program or cell [m/s]; NaN if it is not recorded.
        is_early: whether its command stopped before its target, as a condition ended it.
        reached: how slow it is against `given`, and why; None where it is not.
        critical: limit that it is at for longest; None for none.
    """

    station: str
    ordinal: int
    line: int
    visit: int
    time: float
    max_error: float
    rms_error: float
    max_angle: float
    speeds: SpeedFigures
    given: float = math.nan
    is_early: bool = False
    reached: ReachedSpeed | None = None
    critical: CriticalLimit | None = None

    @property
    def falls_short(self) -> bool:
        """Return whether its command does not come to the speed that is given for it, all the way."""
        return not self.is_early and self.speeds.command < REACHED * self.given


@frozen_dataclass
class PathLine:
    """All moves with a path of the tool of one source line.

    Attributes:
        station: whose program has it.
        line: source line, 0 where unknown.
        moves: in order of time.
        repeatability: RT_p of its passes [m]; NaN where they are not several of one path.
    """

    station: str
    line: int
    moves: tuple[PathMove, ...]
    repeatability: float = math.nan

    @property
    def worst(self) -> PathMove:
        """Return the move with the largest error, the first one where none is known."""
        return max(self.moves, key=lambda move: move.max_error if math.isfinite(move.max_error) else -1.0)

    @property
    def slowest(self) -> PathMove:
        """Return the move that loses most time against its given speed, else the one least near it."""
        return max(
            self.moves,
            key=lambda move: (
                move.reached.lost if move.reached else 0.0,
                -(move.speeds.command / move.given) if move.given > 0.0 else -math.inf,
            ),
        )

    @property
    def rms_error(self) -> float:
        """Return the root of the mean of the squared RMS errors of the moves [m]."""
        return math.sqrt(sum(move.rms_error**2 for move in self.moves) / len(self.moves))

    @property
    def worst_speed(self) -> PathMove | None:
        """Return the move whose AV is the largest in magnitude, None without any."""
        return largest_speed_error(self.moves)


@frozen_dataclass
class PathSummary:
    """The moves of a run that have a path of the tool: lines, arcs, curves and the corners between them.

    Attributes:
        lines: by source line, in the order of stations and lines; empty without any.
        mean_error: mean distance from the path of the tool over all its samples [m].
        rms_error: root of its mean square [m].
        p95_error: its 95th percentile [m].
        conditions: under which figures of accuracy hold.
    """

    lines: tuple[PathLine, ...] = ()
    mean_error: float = math.nan
    rms_error: float = math.nan
    p95_error: float = math.nan
    conditions: AccuracyConditions = field(default_factory=AccuracyConditions)

    @property
    def moves(self) -> tuple[PathMove, ...]:
        """Return all moves in order of time."""
        return tuple(sorted((move for line in self.lines for move in line.moves), key=lambda one: one.time))

    @property
    def worst(self) -> PathMove | None:
        """Return the move with the largest error, None where none is known."""
        known = [move for move in self.moves if math.isfinite(move.max_error)]
        return max(known, key=lambda move: move.max_error, default=None)

    @property
    def max_error(self) -> float:
        """Return the largest distance from the path of the tool [m]; NaN where there is none."""
        return self.worst.max_error if self.worst else math.nan

    @property
    def worst_angle(self) -> PathMove | None:
        """Return the move with the largest error of orientation, None where none is known."""
        known = [move for move in self.moves if math.isfinite(move.max_angle)]
        return max(known, key=lambda move: move.max_angle, default=None)

    @property
    def worst_repeat(self) -> PathLine | None:
        """Return the line whose passes lie apart most, None where no path is repeated."""
        known = [line for line in self.lines if math.isfinite(line.repeatability)]
        return max(known, key=lambda line: line.repeatability, default=None)

    @property
    def worst_speed(self) -> PathMove | None:
        """Return the move whose AV is the largest in magnitude, None without any."""
        return largest_speed_error(self.moves)

    @property
    def slow(self) -> tuple[PathMove, ...]:
        """Return the moves that do not come to the speed that is given for them, in order of time.

        Their ways are too short for their acceleration and jerk, or joints and corners do not allow it.
        """
        return tuple(move for move in self.moves if move.falls_short)

    @property
    def mean_speed_accuracy(self) -> float:
        """Return the mean AV of the moves with AV, a share; NaN without any."""
        known = [move.speeds.accuracy for move in self.moves if math.isfinite(move.speeds.accuracy)]
        return sum(known) / len(known) if known else math.nan

    @property
    def largest_fluctuation(self) -> float:
        """Return the largest FV of the moves [m/s]; NaN without any."""
        known = [move.speeds.fluctuation for move in self.moves if math.isfinite(move.speeds.fluctuation)]
        return max(known, default=math.nan)


def largest_speed_error(moves: tuple[PathMove, ...]) -> PathMove | None:
    """Return the move whose AV is the largest in magnitude, None without any."""
    known = [move for move in moves if math.isfinite(move.speeds.accuracy)]
    return max(known, key=lambda move: abs(move.speeds.accuracy), default=None)


def summarize_path(recording: Recording) -> PathSummary:
    """Return the accuracy of all moves for which the recording has a path error, in order of time.

    A station without drives has moves and their command speeds, and no figure of its attained path.
    """
    stations = [(station, station.series("path_error")) for station in station_views(recording)]
    driven = [error[np.isfinite(error)] for station, error in stations if station.is_driven]
    lines = [line for station, error in stations for line in _lines(station, error)]
    ordered = tuple(sorted(lines, key=lambda line: (line.station, line.line)))
    known = np.concatenate(driven or [np.empty(0)])
    if known.size == 0:
        return PathSummary(ordered, conditions=_conditions(ordered))
    return PathSummary(
        lines=ordered,
        mean_error=float(np.mean(known)),
        rms_error=rms(known),
        p95_error=float(np.percentile(known, 95.0)),
        conditions=_conditions(ordered),
    )


def _conditions(lines: tuple[PathLine, ...]) -> AccuracyConditions:
    given = [move.given for line in lines for move in line.moves if math.isfinite(move.given)]
    cycles = max((len(line.moves) for line in lines), default=0)
    return AccuracyConditions(cycles, min(given, default=math.nan), max(given, default=math.nan))


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


@frozen_dataclass
class _Run:
    """The channels of a station that its moves are cut from, all of them by rows."""

    station: StationView
    error: Array
    ways: tuple[Array, Array]
    turned: tuple[Array, Array]
    speeds: tuple[Array, Array]

    @classmethod
    def of(cls, station: StationView, error: Array) -> "_Run":
        kinds = ("command", "attained")
        command, attained = (station.matrix(f"{kind}_position", 3) for kind in kinds)
        wanted, had = (station.matrix(f"{kind}_orientation", 4) for kind in kinds)
        one, other = (path_speed(station, kind) for kind in kinds)
        return cls(station, error, (command, attained), (wanted, had), (one, other))


def _lines(station: StationView, error: Array) -> Iterator[PathLine]:
    """Yield the moves of a station by source line; `error` are its path errors, shape (n,)."""
    inside = np.flatnonzero(np.isfinite(error))
    ordinals, events, run = station.ordinals(), _events(station), _Run.of(station, error)
    moves: dict[int, list[tuple[PathMove, tuple[Array, Array]]]] = {}
    for samples in np.split(inside, np.flatnonzero(np.diff(ordinals[inside]) != 0) + 1):
        if samples.size:
            ordinal = int(ordinals[samples[0]])
            move = _move(run, samples, ordinal, events.get(ordinal))
            command, attained = run.ways
            moves.setdefault(move.line, []).append((move, (command[samples], attained[samples])))
    for line, passes in moves.items():
        repeats = path_repeatability([ways for _, ways in passes]) if station.is_driven else math.nan
        yield PathLine(station.facts.name, line, tuple(move for move, _ in passes), repeats)


def _move(run: _Run, samples: Indices, ordinal: int, event: MoveEvent | None) -> PathMove:
    """Return the figures of the samples `samples`; the event is None of a move that has not ended."""
    station, (command, attained), (wanted, had) = run.station, run.ways, run.turned
    worst = int(samples[np.argmax(run.error[samples])])
    angle = math.nan
    if event is None or not event.free_orientation:
        angle = largest_angle(
            station.time[samples], (command[samples], wanted[samples]), (attained[samples], had[samples])
        )
    move = PathMove(
        station.facts.name,
        ordinal,
        station.line(worst),
        event.visit if event else 0,
        float(station.time[worst]),
        float(run.error[worst]),
        rms(run.error[samples]),
        angle,
        speed_figures(run.speeds[0][samples], run.speeds[1][samples]),
        math.nan if event is None or event.path_speed is None else event.path_speed,
        event is not None and _is_early(run, samples, event),
        event.reached if event else None,
        event.critical if event else None,
    )
    return move if station.is_driven else _commanded(move, station, int(samples[0]))


def _commanded(move: PathMove, station: StationView, first: int) -> PathMove:
    """Return the figures of a move of an arm without drives, which begins at row `first`."""
    return replace(
        move,
        line=station.line(first),
        time=float(station.time[first]),
        max_error=math.nan,
        rms_error=math.nan,
        max_angle=math.nan,
        speeds=SpeedFigures(command=move.speeds.command),
    )


def _is_early(run: _Run, samples: Indices, event: MoveEvent) -> bool:
    """Return whether the command of a move stopped at another place than its target.

    At the last sample it may still be one sample away from where it stops.
    """
    if not event.target or event.flown > 0.0:
        return False
    time, speeds = run.station.time[samples], run.speeds[0][samples]
    sampled = float(np.max(np.diff(time), initial=0.0)) * float(np.max(speeds, initial=0.0))
    left = np.linalg.norm(run.ways[0][samples[-1]] - np.array(event.target))
    return bool(left > NEAR + sampled)


def _events(station: StationView) -> dict[int, MoveEvent]:
    """Return the moves of a station as executed, by their ordinals."""
    return {
        event.ordinal: event
        for event in station.recording.events
        if isinstance(event, MoveEvent) and event.station == station.facts.name
    }
