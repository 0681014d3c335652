"""Moves along paths of the tool on a section of a motion sequence, each with its parts of path segments."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ropsim.motion import ToolPath, parameter_is_arc_length
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.planning.trajectory.timing import TimedSection
from ropsim.spatial import Array, record


class Part(NamedTuple):
    """A part of a path segment, between two of its parameters [m]."""

    path_segment: PathSegment
    begin: float
    end: float


@record
class MoveOnSection:
    """A move on a section, from the middle of the blend before to the middle of its own.

    Attributes:
        move_number: number of the move.
        start: parameter of the section at which it begins [m].
        end: at which it ends [m].
        parts: of the path segments on which it lies.
    """

    move_number: int
    start: float
    end: float
    parts: tuple[Part, ...]

    @property
    def length(self) -> float:
        """Return the length of its way [m]."""
        return self.end - self.start

    @property
    def blends(self) -> tuple[PathSegment, ...]:
        """Return the blends in which it begins and ends."""
        return tuple(one.path_segment for one in self.parts if one.path_segment.blend is not None)


def moves_on(section: TimedSection) -> Iterator[MoveOnSection]:
    """Yield the moves of a section whose TCP goes along a path of the tool, in order."""
    if not section.part.leads_tool or not section.part.has_path_limits:
        return
    parts, begin, number = list[Part](), 0.0, section.path_segments[0].move_number
    for path_segment, first in zip(section.path_segments, section.part.borders.tolist(), strict=False):
        length, at = path_segment.joints.length, 0.0
        cuts = (0.5 * length,) if path_segment.blend is not None else path_segment.ends
        for cut in cuts:
            parts.append(Part(path_segment, at, cut))
            if found := _span(number, begin, first + cut, parts):
                yield found
            parts, begin, at, number = [], first + cut, cut, number + 1
        parts.append(Part(path_segment, at, length))
    if found := _span(number, begin, float(section.part.borders[-1]), parts):
        yield found


def _span(number: int, begin: float, end: float, parts: list[Part]) -> MoveOnSection | None:
    """Return a span; None of no length, and where the parameter of a path is no length."""
    if end > begin and all(_is_arc_length(one.path_segment.tool) for one in parts):
        return MoveOnSection(number, begin, end, tuple(parts))
    return None


def _is_arc_length(path: ToolPath | None) -> bool:
    return path is not None and parameter_is_arc_length(path) is True


def times_at(section: TimedSection, parameters: Array) -> Array:
    """Return the times from its start on at which a section is at parameters of it [s], shape (k,)."""
    borders = section.part.borders
    owners = np.clip(np.searchsorted(borders, parameters, "right") - 1, 0, len(borders) - 2)
    return section.law.times_of(owners, parameters - borders[owners])
