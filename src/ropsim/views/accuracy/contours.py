"""Contours: tool paths that follow upon each other, and how true the arm was to them as a whole.

The path error of a move is the distance from its own path; of a contour it is that from the whole, so what an
arm cuts at a corner counts once. The error in time is the distance from where the tool centre point should be
at that moment: a contour that comes late as a whole has a large one and may yet have a small path error.
"""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import MotionKind, MoveEvent, TaskEvent
from ropsim.spatial import Array, record
from ropsim.views.accuracy.polyline import at, nearest
from ropsim.views.accuracy.stops import StopFigures
from ropsim.views.channels import StationView

WIDE = 1e-3
"""A path makes a contour where it goes aside by more than this: down to a part and up again is none [m]."""
_STANDS = 1e-7
"""Distance from its end within which a command has arrived [m]."""
_BENDS = 1e-7
"""Change of a unit direction from which on a command does not go straight on."""
_ROUNDING = 1e-9
"""Of times that are added [s]."""
_ROWS = 250
"""Rows that are compared with a contour at once."""


@frozen_dataclass
class ContourFigures:
    """A contour that was driven.

    Attributes:
        station: whose contour it is.
        task: the innermost task that drove it, empty for none.
        lines: first and last source line, 0 where unknown.
        visit: loop pass of the first one.
        moves: number of moves.
        start: when its first move began [s].
        planned_end: when its command arrived [s].
        path_max: largest distance of the attained tool centre point from the contour [m].
        path_mean: mean of that over its rows up to the end of the last move [m].
        time: when it was the largest [s].
        tracking_max: largest distance from where the command was at that moment [m].
        tracking_end: that distance when the command arrived [m].
        overshoot: largest way beyond a corner or its end at which the arm stops [m]; NaN without a stop.
    """

    station: str
    task: str
    lines: tuple[int, int]
    visit: int
    moves: int
    start: float
    planned_end: float
    path_max: float
    path_mean: float
    time: float
    tracking_max: float
    tracking_end: float
    overshoot: float


@record
class ContourRows:
    """The rows of a contour.

    Attributes:
        corners: of its command, without rows between which it goes straight on [m], shape (c, 3).
        attained: positions of the tool centre point [m], shape (k, 3).
        nearest: the places of the contour nearest to them [m], shape (k, 3).
    """

    corners: Array
    attained: Array
    nearest: Array


def contours(
    station: StationView, stops: Sequence[StopFigures]
) -> tuple[tuple[ContourFigures, ContourRows], ...]:
    """Return the contours of a station in order of time, with their rows; none of an arm without drives.

    Args:
        station: the station.
        stops: its stops.
    """
    if not station.is_driven:
        return ()
    command, attained = (station.matrix(f"{kind}_position", 3) for kind in ("command", "attained"))
    known = np.asarray(np.isfinite(command + attained).all(axis=1))
    found = []
    for moves in _chains(station):
        first, last = np.searchsorted(station.time, [moves[0].time, moves[-1].end], side="right")
        rows = np.arange(max(first - 1, 0), last)  # the row at which it begins, too
        if len(rows) < 2 or not known[rows].all():
            continue
        corners = _corners(command[rows])
        if not _goes_aside(corners):
            continue
        own = ContourRows(corners, attained[rows], _nearest(corners, attained[rows]))
        found.append((_figures(station, moves, (rows, command), own, stops), own))
    return tuple(found)


def _chains(station: StationView) -> Iterator[list[MoveEvent]]:
    """Yield the moves with a path of the tool that follow upon each other."""
    events = station.recording.events
    moves = [one for one in events if isinstance(one, MoveEvent) and one.station == station.facts.name]
    chain: list[MoveEvent] = []
    for move in sorted(moves, key=lambda one: one.time):
        if move.motion != MotionKind.PTP:
            chain.append(move)
        elif chain:
            yield chain
            chain = []
    if chain:
        yield chain


def _figures(
    station: StationView,
    moves: Sequence[MoveEvent],
    commanded: tuple[Array, Array],
    own: ContourRows,
    stops: Sequence[StopFigures],
) -> ContourFigures:
    rows, command = commanded
    off = np.linalg.norm(own.attained - own.nearest, axis=1)
    late = np.linalg.norm(own.attained - command[rows], axis=1)
    to_go = np.flatnonzero(np.linalg.norm(command[rows] - command[rows[-1]], axis=1) > _STANDS)
    arrived = min(int(to_go[-1]) + 1, len(rows) - 1) if to_go.size else 0
    start, end = moves[0].time, moves[-1].end
    beyond = [one.overshoot for one in stops if start < one.time <= end and math.isfinite(one.overshoot)]
    worst = int(off.argmax())
    return ContourFigures(
        station.facts.name,
        _task(station, start, end),
        (moves[0].line, moves[-1].line),
        moves[0].visit,
        len(moves),
        start,
        float(station.time[rows[arrived]]),
        float(off[worst]),
        float(off.mean()),
        float(station.time[rows[worst]]),
        float(late.max()),
        float(late[arrived]),
        max(beyond, default=math.nan),
    )


def _task(station: StationView, start: float, end: float) -> str:
    """Return the name of the innermost task that was active all the time."""
    around = [
        one
        for one in station.recording.events
        if isinstance(one, TaskEvent)
        and one.station == station.facts.name
        and one.time <= start + _ROUNDING
        and one.end >= end - _ROUNDING
    ]
    return max(around, key=lambda one: one.depth).name if around else ""


def _corners(way: Array) -> Array:
    """Return the rows of a command between which it goes straight on, its ends among them."""
    moving = np.concatenate(([True], np.linalg.norm(np.diff(way, axis=0), axis=1) > _STANDS))
    way = way[moving]
    if len(way) < 3:
        return way
    steps = np.diff(way, axis=0)
    along = steps / np.linalg.norm(steps, axis=1)[:, np.newaxis]
    bends = np.linalg.norm(np.diff(along, axis=0), axis=1) > _BENDS
    return way[np.concatenate(([True], bends, [True]))]


def _goes_aside(corners: Array) -> bool:
    """Return whether a polyline leaves the straight line from its begin to its corner farthest away."""
    away = corners - corners[0]
    far = int(np.linalg.norm(away, axis=1).argmax())
    along = away[far] / max(float(np.linalg.norm(away[far])), _STANDS)
    return bool(np.linalg.norm(away - np.outer(away @ along, along), axis=1).max() > WIDE)


def _nearest(corners: Array, points: Array) -> Array:
    blocks = [points[first : first + _ROWS] for first in range(0, len(points), _ROWS)]
    return np.concatenate([at(corners, nearest(corners, block)[0]) for block in blocks])
