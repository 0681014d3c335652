"""Changes of a text, in its characters and in the protocol's form."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json


@dataclass(frozen=True, slots=True, order=True)
class Change:
    """New text for a range; lines and characters count from 0.

    Attributes:
        line: first line.
        column: first character on it.
        end_line: last line.
        end_column: character after the last one.
        text: in its place.
    """

    line: int
    column: int
    end_line: int
    end_column: int
    text: str


def applied(document: Document, changes: Iterable[Change]) -> str:
    """Return the text after changes that do not overlap."""
    text = document.text
    for one in sorted(changes, reverse=True):
        start = _offset(document, one.line, one.column)
        text = text[:start] + one.text + text[_offset(document, one.end_line, one.end_column) :]
    return text


def action(title: str, kind: str, document: Document, changes: Sequence[Change]) -> Json:
    """Return changes as something that an editor offers, with the line ends that the document has."""
    line_end = "\r\n" if document.text[document.end(0) :].startswith("\r\n") else "\n"
    edits = [
        {
            "range": {
                "start": document.position(one.line, one.column),
                "end": document.position(one.end_line, one.end_column),
            },
            "newText": one.text.replace("\n", line_end),
        }
        for one in changes
    ]
    return {"title": title, "kind": kind, "edit": {"changes": {document.uri: edits}}}


def refused(title: str, kind: str, reason: str) -> Json:
    """Return something that an editor names and cannot offer, with the reason."""
    return {"title": title, "kind": kind, "disabled": {"reason": reason}}


def _offset(document: Document, line: int, column: int) -> int:
    if line >= len(document.starts):
        return len(document.text)
    return min(document.starts[line] + column, document.end(line))
