"""Folding ranges: tasks, blocks of statements, and comments of several lines."""

import re
from collections.abc import Iterator, Mapping

from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.place import is_cell_file
from ropsim.lsp.cell.sections import cell_folds
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import OfDocument

_COMMENT = re.compile(r"\s*(?:#|//)")


def folding_ranges(
    document: Document, _: OfDocument, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the ranges of lines that can be folded, in order of their first line."""
    if is_cell_file(document):
        return cell_folds(document)
    if not is_program(document):
        return []
    blocks = workshop.uses(document, documents).blocks
    found = [(first - 1, last - 1, "region") for first, last in blocks if first < last]
    found += [(first, last, "comment") for first, last in _comments(document)]
    return [{"startLine": first, "endLine": last, "kind": kind} for first, last, kind in sorted(found)]


def _comments(document: Document) -> Iterator[tuple[int, int]]:
    """Yield first and last line (from 0) of comments that fill several lines."""
    start: int | None = None
    for number in range(len(document.starts) + 1):
        if _COMMENT.match(document.line(number)):
            start = number if start is None else start
        else:
            if start is not None and number - start > 1:
                yield start, number - 1
            start = None
