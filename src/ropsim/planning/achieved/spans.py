"""Spans of moves on paths of the tool: their share of each section, its length and its times."""

from collections.abc import Iterator

import numpy as np

from ropsim.motion import ToolPath, parameter_is_arc_length
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.planning.trajectory.timing import TimedSection
from ropsim.spatial import Array, record


@record
class Span:
    """A move on a section, from the middle of the blend before to the middle of its own.

    Attributes:
        move_number: number of the move.
        start: parameter of the section at which it begins.
        end: at which it ends.
        length: of its way [m].
        own: its path segments without blends.
        behind: its blend, None where it has none.
    """

    move_number: int
    start: float
    end: float
    length: float
    own: tuple[PathSegment, ...]
    behind: PathSegment | None


def spans_of(section: TimedSection) -> Iterator[Span]:
    """Yield the moves of a section whose TCP goes along a path of the tool.

    Args:
        section: of a motion sequence.
    """
    if not section.part.leads_tool or not section.part.has_path_limits:
        return
    borders, begin, own = section.part.borders, 0.0, list[PathSegment]()
    path_segments = section.path_segments
    for number, path_segment in enumerate(path_segments):
        first, end = float(borders[number]), float(borders[number + 1])
        is_last = number + 1 == len(path_segments)
        if path_segment.blend is None:
            own.append(path_segment)
        middle = end if path_segment.blend is None else 0.5 * (first + end)
        ends_here = is_last or path_segment.blend is not None
        if not ends_here and path_segments[number + 1].move_number == path_segment.move_number:
            continue
        blend = path_segment if path_segment.blend is not None else None
        parts = (*own, *((blend,) if blend else ()))
        if middle > begin and all(_is_arc_length(one.tool) for one in parts):
            yield Span(path_segment.move_number, begin, middle, middle - begin, tuple(own), blend)
        begin, own = middle, []


def _is_arc_length(path: ToolPath | None) -> bool:
    return path is not None and parameter_is_arc_length(path) is True


def times_at(section: TimedSection, parameters: Array) -> Array:
    """Return the times from its start on at which a section is at parameters of it [s], shape (k,)."""
    borders = section.part.borders
    owners = np.clip(np.searchsorted(borders, parameters, "right") - 1, 0, len(borders) - 2)
    return section.law.times_of(owners, parameters - borders[owners])
