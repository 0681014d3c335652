"""Where the place of a motion under the pointer is, by the last text without errors."""

from collections.abc import Mapping

from ropsim.core import Span
from ropsim.language import MotionPlaces
from ropsim.lsp.analysis import names
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.parameters import Position
from ropsim.model import Station
from ropsim.spatial import Pose
from ropsim.workbench import Resolved, places_of

_ONE_PATH = ("circ", "spline")
"""Verbs that lead through their points; the others pass one after the other."""


def motion_hover(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> str:
    """Return the destination of a motion, or the via point under the pointer; empty if there is none."""
    motion = workshop.motion(document, position.line)
    line = motion.line - 1 if motion is not None else position.line
    moves = workshop.moves(document, documents, line)
    if moves is None:
        return ""
    around = workshop.named(document, documents)
    places = [
        (place, move.has_free_orientation)
        for move in moves.first
        for place in places_of(move, around.environment)
    ]
    index = _index(motion, position.line + 1, document.column(position) + 1) if motion is not None else 0
    place, is_free = places[index] if index < len(places) else (None, False)
    if place is None:
        return ""
    times = moves.times if motion is not None else moves.count
    first = f" at the first of {times} times" if times > 1 else ""
    free = "; its orientation is free" if is_free else ""
    return f"{_deed(motion, index).format(first)} {resolved_words(place, around.station)}{free}"


def resolved_words(resolved: Resolved, station: Station | None) -> str:
    """Return a location in the world frame, or in that of the base without a cell, and in its own."""
    if resolved.moving:
        return f"{names.pose_words(resolved.X_FT)} in {resolved.moving}, which moves"
    X_WB = station.X_WB if station is not None else Pose()
    known = "the world frame" if station is not None else "the base frame"
    parts = [f"{names.pose_words(X_WB @ resolved.X_BT)} in {known}"]
    if resolved.frame:
        parts.append(f"{names.pose_words(resolved.X_FT)} in {resolved.frame}")
    return "; ".join(parts)


def _index(motion: MotionPlaces, line: int, column: int) -> int:
    """Return which place of a motion is at a line and column from 1; the target where none is."""
    here = (one for one, span in enumerate(motion.spans) if _holds(span, line, column))
    return next(here, len(motion.spans) - 1)


def _holds(span: Span, line: int, column: int) -> bool:
    return (span.line, span.column) <= (line, column) <= (span.end_line, span.end_column)


def _deed(motion: MotionPlaces | None, index: int) -> str:
    if motion is None or index == len(motion.spans) - 1:
        return "goes{} to"
    return "leads{} through" if motion.word in _ONE_PATH else "passes{}"
