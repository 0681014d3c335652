"""The timing of a sequence: sections of its parts, one behind or over the other."""

from collections.abc import Sequence
from math import nan

import numpy as np

from ropsim.core import maker
from ropsim.motion import TimeLaw
from ropsim.planning.trajectory.sections import Section
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.planning.trajectory.timing_kernel import lay_sections
from ropsim.spatial import Array, record

_STOP = nan, 0.0
"""Stands for no overlap of a section and the next one."""


@record
class TimedSection:
    """A part of a sequence at its time.

    Attributes:
        part: segments traversed together.
        start: nominal time at which it begins [s].
        overlap: for how long the section before still lasts then [s].
        end: nominal time at which it ends [s].
    """

    part: Section
    start: float
    overlap: float
    end: float

    @property
    def path_segments(self) -> tuple[PathSegment, ...]:
        """Return its path segments in order."""
        return self.part.path_segments

    @property
    def law(self) -> TimeLaw:
        """Return when it is where on its path segments."""
        return self.part.law


_run = maker(TimedSection)


@record
class Timing:
    """All sections of a sequence.

    Attributes:
        sections: in order; none where nothing moves.
        ends: nominal times at which the moves end [s]: in the middle of their blends, or where they stop.
        table: the runs as numbers: start, end and duration [s], first segment, segments, first path segment,
            and overlap [s] of each, shape (r, 7).
        segments: of all time laws, see `TimeLaw`, shape (8, m).
        path_segment_ends: times of these laws at which their path segments end [s], shape (p,).
    """

    sections: tuple[TimedSection, ...]
    ends: tuple[float, ...]
    table: Array
    segments: Array
    path_segment_ends: Array

    @property
    def duration(self) -> float:
        """Return the nominal time from start to end [s]."""
        return self.sections[-1].end if self.sections else 0.0

    def alone(self, number: int) -> tuple[float, float]:
        """Return the nominal times between which no other section overlaps one [s].

        Args:
            number: of the section.
        """
        section, behind = self.sections[number], self.sections[number + 1 : number + 2]
        return section.start + section.overlap, section.end - (behind[0].overlap if behind else 0.0)


def timing_of(parts: Sequence[Section], moves: int) -> Timing:
    """Return the timing through the parts of a sequence.

    Args:
        parts: of it.
        moves: number of its moves.
    """
    if not parts:
        return Timing((), (0.0,) * moves, np.empty((0, 7)), np.empty((8, 0)), np.empty(0))
    numbers = list[float]()
    for part in parts:
        over = part.over
        left = (over.leave - part.path_segments[-1].begin, over.enter) if over else _STOP
        numbers += (part.law.segments.shape[1], len(part.path_segments), *left)
    segments = np.concatenate([part.law.segments for part in parts], 1)
    ends, requested = np.concatenate([part.law.ends for part in parts]), np.fromiter(numbers, np.float64)
    table, times = np.empty((len(parts), 7)), np.empty((len(parts), 3))
    lay_sections(segments, ends, requested.reshape(-1, 4), table, times)
    table.flags.writeable = segments.flags.writeable = ends.flags.writeable = False
    sections = tuple(_run(part, *at) for part, at in zip(parts, times.tolist(), strict=True))
    return Timing(sections, tuple(_ends(sections, moves)), table, segments, ends)


def _ends(sections: Sequence[TimedSection], moves: int) -> list[float]:
    """Return the nominal times at which moves end [s], see `Timing`."""
    ends = np.zeros(moves)
    for section, overlap in zip(sections, (*[section.overlap for section in sections[1:]], 0.0), strict=True):
        path_segments = section.part.path_segments
        passing = [number for number, path_segment in enumerate(path_segments) if len(path_segment.ends)]
        if passing:
            at = [path_segments[number].ends for number in passing]
            numbers = np.repeat(passing, [len(one) for one in at])
            here = [
                path_segments[number].move_number + np.arange(len(one))
                for number, one in zip(passing, at, strict=True)
            ]
            ends[np.concatenate(here)] = section.start + section.law.times_of(numbers, np.concatenate(at))
        ends[path_segments[-1].last_move] = section.end - 0.5 * overlap
    found: list[float] = np.maximum.accumulate(ends).tolist()
    return found
