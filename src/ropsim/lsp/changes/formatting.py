"""A program in its one form, as the edits that bring it there."""

import re
from collections.abc import Iterator, Mapping

from ropsim.language import formatted
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import OfDocument

_LINE = re.compile(r"[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+\Z")

_Change = tuple[int, int, str]
"""First line, line behind the last one, both from 0, and the new text."""


def formatting(
    document: Document, _: OfDocument, _documents: Mapping[str, Document], _workshop: Workshop
) -> list[Json]:
    """Return an edit for each line that has another form, in order; formatted lines stay untouched."""
    if not is_program(document):
        return []
    after = formatted(document.text)
    old, new = _LINE.findall(document.text), _LINE.findall(after)
    changes = list(_changes(old, new))
    if _changed(old, changes) != after:
        changes = [(0, len(old), after)]
    return [{"range": _range(document, first, last), "newText": text} for first, last, text in changes]


def _changes(old: list[str], new: list[str]) -> Iterator[_Change]:
    """Yield the changes from old to new lines, where lines are changed and blank ones are left out only."""
    place = 0
    for number, line in enumerate(old):
        put = new[place] if place < len(new) else ""
        if not line.strip() and put.strip():
            yield number, number + 1, ""
            continue
        place += 1
        if line != put:
            yield number, number + 1, put


def _changed(lines: list[str], changes: list[_Change]) -> str:
    after = list(lines)
    for first, last, text in reversed(changes):
        after[first:last] = [text]
    return "".join(after)


def _range(document: Document, first: int, last: int) -> Json:
    return {"start": document.position(first, 0), "end": document.position(last, 0)}
