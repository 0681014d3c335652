"""Fine stops: how far the arm goes beyond its place, and when it stays there."""

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import MoveEvent
from ropsim.spatial import Array
from ropsim.views.channels import StationView

BAND = 1e-4
"""Radius of the limit band around the place where the arm comes to rest [m]."""


@frozen_dataclass
class StopFigures:
    """A move that ends in a stop, ISO 9283:1998, 7.4 and 7.5.

    Attributes:
        station: whose move it is.
        line: its source line, 0 where unknown.
        visit: its loop pass.
        time: when the arm first came into the limit band [s].
        stabilization: position stabilization time: from then until it stays there [s].
        overshoot: OV, largest distance from the place of rest after that; 0 within the band [m].
    """

    station: str
    line: int
    visit: int
    time: float
    stabilization: float
    overshoot: float


def stopping(time: Array, command: Array, attained: Array) -> tuple[float, float, float]:
    """Return how a move comes to rest.

    Args:
        time: of the rows from its begin to that of the next motion [s], shape (k,), k at least 1.
        command: commanded positions of the tool centre point [m], shape (k, 3).
        attained: attained ones, alike; the last one is the place of rest.

    Returns:
        `time`, `stabilization` and `overshoot` as in `StopFigures`; times are those of rows. They are looked
        for from when the command has come to its end, so that a path may pass its end before.
    """
    away, to_go = (np.linalg.norm(way - way[-1], axis=1) for way in (attained, command))
    outside = away > BAND
    ended = int(np.flatnonzero(to_go > BAND)[-1]) + 1 if (to_go > BAND).any() else 0
    came = ended + int(np.argmin(outside[ended:]))
    later = np.flatnonzero(outside[came:])
    if not later.size:
        return float(time[came]), 0.0, 0.0
    stays = came + int(later[-1]) + 1
    return float(time[came]), float(time[stays] - time[came]), float(away[came:].max())


def stop_figures(station: StationView) -> tuple[StopFigures, ...]:
    """Return the stops of a station, in order of time; moves within the limit band are left out.

    A kinematic run has none: its arm is where its reference is.
    """
    if station.recording.facts.is_kinematic:
        return ()
    events = station.recording.events
    moves = [one for one in events if isinstance(one, MoveEvent) and one.station == station.facts.name]
    moves.sort(key=lambda one: one.time)
    ends = [*(one.time for one in moves), station.recording.duration][1:]
    command, attained = (station.matrix(f"{kind}_position", 3) for kind in ("command", "attained"))
    found = []
    for move, end in zip(moves, ends, strict=True):
        if move.flown > 0.0:
            continue
        first, last = np.searchsorted(station.time, [move.time, end], side="right")
        wanted, way = command[first:last], attained[first:last]
        if not len(way) or not np.isfinite(wanted + way).all() or np.ptp(way, axis=0).max() <= 2.0 * BAND:
            continue
        place = station.facts.name, move.line, move.visit
        found.append(StopFigures(*place, *stopping(station.time[first:last], wanted, way)))
    return tuple(found)
