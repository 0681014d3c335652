"""Makes a move of the joints one along a line, and the other way."""

import re
from collections.abc import Iterator, Mapping

from ropsim import language
from ropsim.lsp import findings
from ropsim.lsp.document import Document
from ropsim.lsp.edits import Change, action, applied
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import InRange
from ropsim.lsp.workshop import Workshop

_MOVE = re.compile(r"\s*(?:\d+\.\s+)?(?:if\b.*\bthen\s+)?(mov|lin)\s", re.IGNORECASE)
_OTHER = {"mov": ("lin", "a line"), "lin": ("mov", "a joint move")}


def way_of_move(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[Json]:
    """Yield the change of the word of the move on a line, where it is right with the other one, too."""
    number = params.range.start.line
    found = _MOVE.match(document.line(number))
    if number != params.range.end.line or found is None:
        return
    word, way = _OTHER[found[1].lower()]
    change = Change(number, found.start(1), number, found.end(1), word)
    around = workshop.named(document, documents)
    after = applied(document, [change])
    compiled = language.compile(after, around.environment, document.name, workshop.lines)
    if not any(one.is_error or findings.touches(one.span, number, number) for one in compiled.diagnostics):
        yield action(f"make it {way} (`{word}`)", "refactor.rewrite", document, [change])
