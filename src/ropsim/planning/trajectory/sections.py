"""Sections of a motion sequence, each from rest to rest, with their time laws."""

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, floor, log
from typing import NamedTuple

import numpy as np

from ropsim.model import LookAhead
from ropsim.motion import PathLimits, TimeLaw, TimeLawPlanner, own_law_of
from ropsim.planning.blends.blend import JointSpaceBlend
from ropsim.planning.path_limits.path_limits import along_with
from ropsim.planning.trajectory.move_borders import Counts, on_moves
from ropsim.planning.trajectory.segments import JoinedSegments, PathSegment
from ropsim.planning.trajectory.timing_kernel import lay_horizons
from ropsim.spatial import Array, record

_NOTHING = np.zeros(1, dtype=np.intp)
_MORE = 1.3, 1.2, 1.1
"""Multiples of the speeds in bends that bounds are fitted to, one time after the other."""
_LADDER = 1.2
"""Ratio of neighbouring speeds that are tried as bounds in bends."""
_REACHED = 0.98
"""Share of the programmed speed from which on lower bounds are not tried: it is reached."""
_LOWEST, _HIGHEST = 0.6, 1.5
"""Which of them are tried, as multiples of the greatest speed so far."""


class TimingRules(NamedTuple):
    """How sections are timed.

    Attributes:
        law: plans their time laws.
        look_ahead: how far beyond the present move the path is known.
    """

    law: TimeLawPlanner
    look_ahead: LookAhead


@record
class Section:
    """Segments traversed together from rest to rest, and their timing.

    Attributes:
        path_segments: in order.
        path_limits: with which they are planned, of all path segments in a row; none where the path is one of
            time.
        counts: how many path limits each path segment has, shape (p,).
        law: time law along them; it counts segments, regardless of the path limits of each.
        over: how it goes over into the next one; None where it stops.
    """

    path_segments: tuple[PathSegment, ...]
    path_limits: PathLimits
    counts: Counts
    law: TimeLaw
    over: JointSpaceBlend | None

    @property
    def has_path_limits(self) -> bool:
        """Return whether its time law is planned with path limits; else its path is one of time."""
        return len(self.path_limits) > 0

    @property
    def leads_tool(self) -> bool:
        """Return whether it is on a path of the tool, so that limits of the tool hold."""
        return self.path_segments[0].tool is not None

    @property
    def borders(self) -> Array:
        """Return path parameters at which path segments begin, then the end of the last, shape (p + 1,)."""
        ends = np.append(0.0, self.path_limits.ends)
        return np.asarray(ends[np.append(0, np.cumsum(self.counts))])


def sections_of(joined: Sequence[JoinedSegments], rules: TimingRules) -> tuple[Section, ...]:
    """Return the sections of a sequence: between them the arm stops or motions overlap.

    Args:
        joined: the segments, as from `segments_of`.
        rules: time law and look-ahead.
    """
    return tuple(_quickest(path_segments, over, rules) for path_segments, over in joined)


def section_of(
    path_segments: Sequence[PathSegment], over: JointSpaceBlend | None, rules: TimingRules
) -> Section:
    """Return segments with their time law: planned interval by interval, expressed segment by segment.

    Args:
        path_segments: that are traversed together from rest to rest.
        over: how they go over into the next ones; None where they stop.
        rules: time law and look-ahead.
    """
    if own := own_law_of(path_segments[0].joints):
        return Section(tuple(path_segments), path_segments[0].path_limits, _NOTHING, own, over)
    rows = [path_segment.path_limits.rows for path_segment in path_segments]
    counts = np.array([len(each) for each in rows])
    path_limits = PathLimits(np.concatenate(rows)) if len(rows) > 1 else path_segments[0].path_limits
    return planned_section(path_segments, path_limits, counts, over, rules)


def planned_section(
    path_segments: Sequence[PathSegment],
    path_limits: PathLimits,
    counts: Counts,
    over: JointSpaceBlend | None,
    rules: TimingRules,
) -> Section:
    """Return path segments with the time law of path limits that count for them instead of their own.

    Args:
        path_segments: that are traversed together from rest to rest.
        path_limits: of all path segments in a row.
        counts: how many of them each path segment has, one or more, shape (p,).
        over: how they go over into the next ones; None where they stop.
        rules: time law and look-ahead.
    """
    divided = on_moves(path_segments, path_limits.rows, counts)
    bounds = np.empty((len(divided.rows), 6))
    bounds[:, :4] = divided.rows
    ahead = rules.look_ahead
    lay_horizons(divided.moves, divided.of_moves, ahead.moves, ahead.braking, bounds)
    law = rules.law(bounds, divided.counts.astype(np.float64))
    if divided.rows is not path_limits.rows:
        path_limits = PathLimits(divided.rows)
    return Section(tuple(path_segments), path_limits, divided.counts, law, over)


def _quickest(
    path_segments: Sequence[PathSegment], over: JointSpaceBlend | None, rules: TimingRules
) -> Section:
    """Return segments with the bounds in bends that take the least time.

    Bends leave less for changes of speed the faster they may be passed. So the bounds of the highest speed
    are seldom the quickest. Others are tried: those of shares of it; those of speeds of a ladder that is the
    same for all programmed speeds, so that raising these takes no choice away; at last those of little more
    than the speeds that are reached with the quickest.
    """
    found = [section_of(path_segments, over, rules)]
    found += (
        section_of([_gentler(one, number) for one in path_segments], over, rules)
        for number in range(max(len(path_segment.gentler) for path_segment in path_segments))
    )
    best = min(found, key=_duration)
    if not any(one.bend for one in path_segments):
        return best
    slower = (section_of(_below(path_segments, speed), over, rules) for speed in _ladder(path_segments, best))
    first, *others = _MORE
    best = min((_refined(one, first, rules) for one in (best, *slower)), key=_duration)
    for more in others:
        best = _refined(best, more, rules)
    return best


def _duration(part: Section) -> float:
    return part.law.duration


def _ladder(path_segments: Sequence[PathSegment], part: Section) -> list[float]:
    """Return speeds that are tried as bounds in bends, near the greatest one that is reached."""
    reached = float(part.law.speeds.max())
    bounds = [float(one.path_limits.bounds[:, 0].max()) for one in path_segments if one.bend and one.gentler]
    lowest, highest = _LOWEST * reached, min(_HIGHEST * reached, max(bounds, default=0.0))
    if not 0.0 < reached < _REACHED * highest:
        return []
    first, last = (log(speed) / log(_LADDER) for speed in (lowest, highest))
    return [_LADDER**number for number in range(ceil(first), floor(last) + 1)]


def _below(path_segments: Sequence[PathSegment], speed: float) -> list[PathSegment]:
    """Return path segments with bounds that go together if a speed is not exceeded in their bends."""
    return [
        replace(
            one, path_limits=along_with(one.bend.within(np.full(one.bend.cells, speed)), one.coordination)
        )
        if one.bend and one.gentler
        else one
        for one in path_segments
    ]


def _refined(part: Section, more: float, rules: TimingRules) -> Section:
    """Return a section that is quicker as its bends leave more for changes of speed, or the same.

    Bends are passed more slowly than they allow where the tool has to slow down before or behind. With bounds
    for little more than the speeds that it has there, more acceleration and jerk are left along the path.

    Args:
        part: the section.
        more: multiple of these speeds that is allowed.
        rules: time law and look-ahead.
    """
    return min(part, section_of(_at_own_speeds(part, more), part.over, rules), key=_duration)


def _at_own_speeds(part: Section, more: float) -> list[PathSegment]:
    """Return path segments with bounds for a multiple of the speeds that a section has in its bends."""
    bent = [(number, one.bend.borders) for number, one in enumerate(part.path_segments) if one.bend]
    numbers = np.repeat([number for number, _ in bent], [len(borders) for _, borders in bent])
    times = part.law.times_of(numbers, np.concatenate([borders for _, borders in bent]))
    speeds, found, first = part.law.at(times).speeds, list(part.path_segments), 0
    for number, borders in bent:
        here, one = speeds[first : first + len(borders)], found[number]
        first += len(borders)
        if one.bend:
            most = one.bend.within(more * np.maximum(here[1:], here[:-1]))
            found[number] = replace(one, path_limits=along_with(most, one.coordination))
    return found


def _gentler(path_segment: PathSegment, number: int) -> PathSegment:
    last = len(path_segment.gentler) - 1
    return (
        path_segment
        if last < 0
        else replace(path_segment, path_limits=path_segment.gentler[min(number, last)])
    )
