"""Which limit of the tool keeps a move below its speed: seen where its time law is slow."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.flow import SpeedCause
from ropsim.motion import LawRows, ToolLimits, constant_derivatives
from ropsim.planning.achieved.moves_on_sections import MoveOnSection
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.planning.trajectory.timing import TimedSection

SLOW = 0.9
"""Share of the programmed speed below which a move is slow."""
SAMPLES = 48
"""Times at which the law of a move is looked at, evenly spaced."""
_REACHED = 0.98
"""Share of a bound from which on it counts as reached."""
_SHARES = np.linspace(0.0, 1.0, 9)
_CLOSE = np.linspace(0.0, 1.0, 257)
"""Shares of a way between which a bend of a curve through many points is not missed."""


def law_samples(section: TimedSection, times: Sequence[float]) -> LawRows:
    """Return what the law of a section does on a move, in the middles of even parts of its time.

    Args:
        section: with its law.
        times: at which the move begins and ends, from the start of the section on [s].
    """
    begin, end = times
    return section.law.at(begin + (np.arange(SAMPLES) + 0.5) / SAMPLES * (end - begin))


def tool_cause(
    section: TimedSection, span: MoveOnSection, times: Sequence[float], limits: ToolLimits
) -> tuple[SpeedCause, float, float]:
    """Return the cause, the bound that counts, and the angle of the corner [rad], see `ReachedSpeed`.

    Where the law is slow, the bound that it is at gets the speed that is missing there. Ramps count for the
    zone if the speed is reached between them, else for acceleration or jerk: then the move is too short.
    Ramps of rotation count for its speed where that is reached.

    Args:
        section: with the law that keeps the limits of the tool.
        span: of the move on it.
        times: at which it begins and ends, from the start of the section on [s].
        limits: of the tool.
    """
    lost = dict.fromkeys(SpeedCause, 0.0)
    rows = law_samples(section, times)
    numbers, parameters, speeds, accelerations = (
        rows.path_segments,
        rows.parameters,
        rows.speeds,
        rows.accelerations,
    )
    borders, path_limits = section.part.borders, section.part.path_limits
    whole = np.searchsorted(path_limits.ends[:-1], borders[numbers] + parameters, "right")
    bounds = path_limits.bounds[whole]
    for k in np.flatnonzero(speeds < SLOW * limits.speed).tolist():
        path_segment = section.path_segments[int(numbers[k])]
        at = float(parameters[k]), float(speeds[k]), float(accelerations[k]), bounds[k].tolist()
        lost[_cause(path_segment, at, limits)] += 1.0 - float(speeds[k]) / limits.speed
    if lost[SpeedCause.TURN_SPEED] > 0.0:
        lost[SpeedCause.TURN_SPEED] += lost.pop(SpeedCause.TURN_ACCELERATION)
    ramps = lost[SpeedCause.ACCELERATION] + lost[SpeedCause.JERK]
    if float(speeds.max()) >= SLOW * limits.speed and lost[SpeedCause.ZONE] > 0.0:
        lost[SpeedCause.ZONE] += ramps
        lost[SpeedCause.ACCELERATION] = lost[SpeedCause.JERK] = 0.0
    elif lost[SpeedCause.ACCELERATION] > 0.0:
        lost[SpeedCause.ACCELERATION], lost[SpeedCause.JERK] = ramps, 0.0
    cause = max(lost, key=lost.__getitem__)
    if cause is SpeedCause.ZONE and span.blends:
        blend = min(span.blends, key=lambda one: _speed_in(one, rows, section)).blend
        assert blend is not None
        return cause, blend.zone, blend.turn
    return cause, _value(cause, span, limits), 0.0


def _speed_in(blend: PathSegment, rows: LawRows, section: TimedSection) -> float:
    """Return the least of the speeds that are known in a blend [m/s], infinity for none."""
    known = [section.path_segments[one] is blend for one in rows.path_segments.tolist()]
    return float(rows.speeds[known].min(initial=math.inf))


def _cause(
    path_segment: PathSegment, at: tuple[float, float, float, list[float]], limits: ToolLimits
) -> SpeedCause:
    """Return what counts at a place of a path segment: parameter, speed, acceleration, and their bounds."""
    s, speed, acceleration, (most_speed, most_acceleration, most_jerk) = at
    tool = path_segment.tool
    assert tool is not None
    turning = float(np.linalg.norm(tool.tool(np.array([s])).d1[0, 3:]))
    is_fastest = speed >= _REACHED * most_speed
    if is_fastest and turning * most_speed >= _REACHED * limits.orientation_speed:
        return SpeedCause.TURN_SPEED
    if path_segment.blend is not None:
        return SpeedCause.ZONE
    turns = (
        turning * most_acceleration >= _REACHED * limits.orientation_acceleration
        or turning * most_jerk >= _REACHED * limits.orientation_jerk
    )
    if turns:
        return SpeedCause.TURN_ACCELERATION
    bounds = (most_speed, limits.speed), (most_acceleration, limits.acceleration), (most_jerk, limits.jerk)
    if constant_derivatives(tool) is None and any(most < _REACHED * limit for most, limit in bounds):
        return SpeedCause.BEND
    if path_segment.coordination is not None and (is_fastest or most_jerk < _REACHED * limits.jerk):
        return SpeedCause.EXTERNAL
    return SpeedCause.ACCELERATION if abs(acceleration) >= _REACHED * most_acceleration else SpeedCause.JERK


def _value(cause: SpeedCause, span: MoveOnSection, limits: ToolLimits) -> float:
    values = {
        SpeedCause.ACCELERATION: limits.acceleration,
        SpeedCause.JERK: limits.jerk,
        SpeedCause.TURN_SPEED: limits.orientation_speed,
        SpeedCause.TURN_ACCELERATION: limits.orientation_acceleration,
    }
    if cause is SpeedCause.BEND:
        return _least_radius(span)
    return values.get(cause, 0.0)


def _least_radius(span: MoveOnSection) -> float:
    """Return the least radius of the way of a move without its blends [m], infinity of a straight one."""
    most = 0.0
    for path_segment, begin, end in span.parts:
        tool = path_segment.tool
        if path_segment.blend is None and tool is not None and constant_derivatives(tool) is None:
            rows = tool.tool(begin + _CLOSE * (end - begin))
            most = max(most, float(np.linalg.norm(rows.d2[:, :3], axis=1).max()))
    return 1.0 / most if most > 0.0 else math.inf


def turn_of(span: MoveOnSection) -> float:
    """Return the angle by which the tool turns on the way of a move [rad]."""
    total = 0.0
    for path_segment, begin, end in span.parts:
        if path_segment.tool is not None:
            rows = path_segment.tool.tool(begin + _SHARES * (end - begin))
            total += (end - begin) * float(np.linalg.norm(rows.d1[:, 3:], axis=1).mean())
    return total
