"""Cornering deviations: how a corner is rounded, and how far the arm goes beyond the path behind it."""

import math
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.flow import MoveEvent
from ropsim.spatial import Array
from ropsim.views.accuracy.polyline import at, nearest
from ropsim.views.channels import StationView

_MOST_ROWS = 400
"""Maximum number of rows of a blend that are evaluated; of more every second, third, … one."""

_ALONG = 1e-6
"""Sine of the angle of a corner below which it has no outer side."""


@frozen_dataclass
class CornerFigures:
    """A corner of two paths that is passed without a stop, ISO 9283:1998, 8.5.

    Attributes:
        station: whose move ends there.
        line: source line of that move, 0 where unknown.
        visit: its loop pass.
        time: when the arm was nearest to the corner [s]; without drives its command.
        zone: distance from the corner at which the commanded path leaves the one before [m].
        planned: least distance of the commanded path from the corner point [m].
        rounding: CR, that of the attained path [m]; NaN without drives, as is CO.
        overshoot: CO, largest distance of the attained path beyond the commanded one behind the corner, on
            its outer side [m]; NaN without one.
    """

    station: str
    line: int
    visit: int
    time: float
    zone: float
    planned: float
    rounding: float
    overshoot: float


def cornering(corner: Array, zone: float, middle: int, command: Array, attained: Array) -> tuple[float, ...]:
    """Return how a corner is passed.

    The outer side is the one on which the path before would go on; only points there overshoot.

    Args:
        corner: point [m], shape (3,).
        zone: distance from it at which the commanded path leaves the one before [m].
        middle: row at which the next move begins.
        command: commanded positions from the middle of the move before to that of the next [m], shape (k, 3).
        attained: attained ones, alike.

    Returns:
        Row at which the arm was nearest, `planned`, CR and CO as in `CornerFigures`.
    """
    places, (planned, rounding) = zip(*(_nearest(way, corner) for way in (command, attained)), strict=True)
    far = np.linalg.norm(command - corner, axis=1) >= zone
    before, behind = np.flatnonzero(far[:middle]), middle + np.flatnonzero(far[middle:])
    if not before.size or not behind.size:
        return places[1], planned, rounding, math.nan
    comes, goes = (_unit(way) for way in (corner - command[before[-1]], command[behind[0]] - corner))
    outward = comes - (comes @ goes) * goes
    if not np.linalg.norm(outward) > _ALONG:
        return places[1], planned, rounding, math.nan
    later = attained[middle:]
    on, away = nearest(command, later)
    beyond = (later - at(command, on)) @ _unit(outward) > 0.0
    return places[1], planned, rounding, float(np.max(away[beyond], initial=0.0))


def _nearest(way: Array, corner: Array) -> tuple[float, float]:
    place, distance = nearest(way, corner[None])
    return float(place[0]), float(distance[0])


def _unit(way: Array) -> Array:
    return np.asarray(way / max(float(np.linalg.norm(way)), np.finfo(float).tiny))


def corner_figures(station: StationView) -> tuple[CornerFigures, ...]:
    """Return the corners that a station passes without a stop, in order of time."""
    events = station.recording.events
    moves = [one for one in events if isinstance(one, MoveEvent) and one.station == station.facts.name]
    command, attained = (station.matrix(f"{kind}_position", 3) for kind in ("command", "attained"))
    found = []
    for move, behind in pairwise(sorted(moves, key=lambda one: one.time)):
        if not (move.flown > 0.0 and len(move.target) == 3):
            continue
        corner = np.array(move.target)
        rows = _rows(station.time, move, behind, command, corner)
        if len(rows) < 2 or not np.isfinite(command[rows] + attained[rows]).all():
            continue
        middle = int(np.searchsorted(station.time[rows], behind.time))
        row, *figures = cornering(corner, move.flown, middle, command[rows], attained[rows])
        time = float(np.interp(row, np.arange(len(rows)), station.time[rows]))
        if not station.is_driven:
            figures[1:] = [math.nan, math.nan]
        name = station.facts.name
        found.append(CornerFigures(name, move.line, move.visit, time, move.flown, *figures))
    return tuple(found)


def _rows(
    time: Array, move: MoveEvent, behind: MoveEvent, command: Array, corner: Array
) -> npt.NDArray[np.intp]:
    """Return the rows that belong to a corner between two moves.

    They reach to where the command is twice the zone before it and four times the zone behind it, but not
    beyond the middles of both moves.
    """
    halves = (0.5 * (move.time + behind.time), behind.time, 0.5 * (behind.time + behind.end))
    first, middle, last = np.searchsorted(time, halves)
    away = np.linalg.norm(command[first:last] - corner, axis=1)
    far = np.flatnonzero(away[: middle - first] >= 2.0 * move.flown)
    gone = np.flatnonzero(away[middle - first :] >= 4.0 * move.flown)
    first += far[-1] if far.size else 0
    last = middle + gone[0] + 1 if gone.size else last
    return np.arange(first, last, max(1, math.ceil((last - first) / _MOST_ROWS)))
