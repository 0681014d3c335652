"""Places that an editor sends, brought into the document: no request sees a line that is not there."""

from typing import TypeVar

from msgspec.structs import replace

from ropsim.lsp.document import Document
from ropsim.lsp.protocol import AtPosition, InRange, Position, Range

P = TypeVar("P")


def within(document: Document, params: P) -> P:
    """Return parameters whose position or range lies in a document.

    A place beyond a line becomes its end, one below the text the end of the text, as the protocol says; a
    range whose end stands before its start becomes the place of its start.
    """
    if isinstance(params, AtPosition):
        return replace(params, position=_inside(document, params.position))
    if isinstance(params, InRange):
        start, end = _inside(document, params.range.start), _inside(document, params.range.end)
        return replace(params, range=Range(start, max(start, end, key=_order)))
    return params


def _inside(document: Document, position: Position) -> Position:
    last = len(document.starts) - 1
    if position.line > last:
        return Position(last, document.width(last))
    return Position(position.line, min(position.character, document.width(position.line)))


def _order(position: Position) -> tuple[int, int]:
    return position.line, position.character
