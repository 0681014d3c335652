"""Fine stops: whether the arm comes to its place, how far it goes beyond it, and when it stays there."""

import math

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import MoveEvent
from ropsim.spatial import Array
from ropsim.views.channels import StationView

BAND = 1e-4
"""Radius of the limit band around the place of the stop [m]."""
STILL = 0.1
"""Time for which the arm must stay within the limit band to have come to rest [s]."""
_REACHED = 1e-3
"""Distance up to which a stop counts as reached where the recording does not say so [m]."""


@frozen_dataclass
class StopFigures:
    """A move that ends in a stop, ISO 9283:1998, 7.4 and 7.5.

    Its place is where the arm came to rest: where it was in position, and stayed within the limit band for
    `STILL` before it went on. Otherwise its place is the commanded one: an arm that swings stands still for a
    moment wherever it turns.

    Attributes:
        station: whose move it is.
        line: its source line, 0 where unknown.
        visit: its loop pass.
        time: when the arm first came to its place [s]; NaN where it never did.
        stabilization: position stabilization time: from then until it stays within the limit band [s]; NaN
            where it does not stay there before it goes on.
        overshoot: OV, largest distance from its place after the arm first came there; 0 within the band [m];
            NaN where a stop that is not reached never came there.
        away: distance of the attained place from the commanded one at the end of the stop [m].
        is_reached: whether the arm was in position before it went on.
    """

    station: str
    line: int
    visit: int
    time: float
    stabilization: float
    overshoot: float
    away: float = 0.0
    is_reached: bool = True


def stopping(
    time: Array, command: Array, attained: Array, place: Array | None = None
) -> tuple[float, float, float]:
    """Return how a move comes to rest.

    Args:
        time: of the rows from its begin to that of the next motion [s], shape (k,), k at least 1.
        command: commanded positions of the tool centre point [m], shape (k, 3); the last is its target.
        attained: attained ones, alike.
        place: of the stop [m], shape (3,); None for the one that is commanded.

    Returns:
        `time`, `stabilization` and `overshoot` as in `StopFigures`, all of them NaN where the arm never came
        to its place; times are times of rows.
    """
    place = command[-1] if place is None else place
    came = _arrival(command, attained, place)
    if came is None:
        return math.nan, math.nan, math.nan
    away = _distances(attained[came:], place)
    later = np.flatnonzero(away > BAND)
    if not later.size:
        return float(time[came]), 0.0, 0.0
    stays = came + int(later[-1]) + 1
    lasted = float(time[stays] - time[came]) if stays < len(time) else math.nan
    return float(time[came]), lasted, float(away.max())


def _place(time: Array, command: Array, attained: Array) -> Array:
    """Return where an arm in position rests: where it stood for `STILL`, otherwise its target."""
    last, long = attained[-1], time[-1] - time[0] > STILL
    rested = attained[np.searchsorted(time, time[-1] - STILL) :]
    return np.asarray(last if long and _distances(rested, last).max() <= BAND else command[-1])


def _arrival(command: Array, attained: Array, place: Array) -> int | None:
    """Return the row at which the arm first came to its place, None where it never did.

    The arm comes there within the limit band, or it passes by: between two rows, or at a distance. It has
    passed by if its remaining distance lies behind it, or if it moves away to more than twice its least
    distance. This counts from when the command has come to its end, so that a path may pass its end before;
    an arm that is ahead of its command may be beyond its place then.
    """
    to_go = np.flatnonzero(_distances(command, command[-1]) > BAND)
    ended = int(to_go[-1]) + 1 if to_go.size else 0
    if to_go.size:
        onward = _unit(command[-1] - command[to_go[-1]])
        behind = np.flatnonzero((attained[:ended] - place) @ onward <= BAND)
        early = int(behind[-1]) + 1 if behind.size else 0
        if early < ended:
            return early
    left = attained[ended:] - place
    away = np.linalg.norm(left, axis=1)
    nearest = np.minimum.accumulate(away)
    there = (away <= BAND) | (left @ left[0] <= 0.0)
    gone = away > 2.0 * nearest + BAND
    found = np.flatnonzero(there)
    passed = np.flatnonzero(gone)
    if passed.size and not (found.size and found[0] < passed[0]):
        return ended + int(np.argmin(away[: passed[0]]))
    return ended + int(found[0]) if found.size else None


def _distances(places: Array, place: Array) -> Array:
    return np.asarray(np.linalg.norm(places - place, axis=1))


def _unit(way: Array) -> Array:
    return np.asarray(way / max(float(np.linalg.norm(way)), np.finfo(float).tiny))


def stop_figures(station: StationView) -> tuple[StopFigures, ...]:
    """Return the stops of a station, in order of time; moves within the limit band are left out if reached.

    An arm without drives has no figures: it follows its reference exactly.
    """
    if not station.is_driven:
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
        if not len(way) or not np.isfinite(wanted + way).all():
            continue
        if np.ptp(way, axis=0).max() <= 2.0 * BAND and _in_position(move) is not False:
            continue
        found.append(_stop(move, station.time[first:last], wanted, way))
    return tuple(found)


def _in_position(move: MoveEvent) -> bool | None:
    """Return whether an arm was in position when a move was over, None where that is not known."""
    return None if move.out_of_position is None else move.out_of_position <= 1.0


def _stop(move: MoveEvent, time: Array, command: Array, attained: Array) -> StopFigures:
    """Return the figures of a stop; command and attained positions are at its rows."""
    away = float(np.linalg.norm(attained[-1] - command[-1]))
    known = _in_position(move)
    is_reached = away <= _REACHED if known is None else known
    place = _place(time, command, attained) if is_reached else None
    came, stabilization, overshoot = stopping(time, command, attained, place)
    if is_reached and not math.isfinite(came):
        overshoot = 0.0  # in position, however slowly it comes nearer
    return StopFigures(move.station, move.line, move.visit, came, stabilization, overshoot, away, is_reached)
