"""Code actions for lines: mend findings, write types, name locations, change moves, make tasks."""

import re
from collections.abc import Iterator, Mapping

from ropsim import language
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.changes import findings
from ropsim.lsp.changes.extract_task import extract_task
from ropsim.lsp.changes.name_location import name_location, write_types
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.edits import Change, action, applied
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import ActionsIn, InRange

_MOVE = re.compile(r"\s*(?:\d+\.\s+)?(?:if\b.*\bthen\s+)?(mov|lin)\s", re.IGNORECASE)
_OTHER = {"mov": ("lin", "a line"), "lin": ("mov", "a joint move")}


def way_of_move(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[Json]:
    """Yield the change of the motion word of a line if the line stays correct with it."""
    number = params.range.start.line
    found = _MOVE.match(document.line(number))
    if number != params.range.end.line or found is None:
        return
    word, motion = _OTHER[found[1].lower()]
    change = Change(number, found.start(1), number, found.end(1), word)
    around = workshop.named(document, documents)
    after = applied(document, [change])
    compiled = language.compile(after, around.environment, document.name, workshop.lines)
    if not any(one.is_error or findings.touches(one.span, number, number) for one in compiled.diagnostics):
        yield action(f"make it {motion} (`{word}`)", "refactor.rewrite", document, [change])


# The kinds of actions offered.
KINDS = ("quickfix", "refactor.rewrite", "refactor.extract")

_MADE = (write_types, name_location, way_of_move, extract_task)


def actions(
    document: Document, params: ActionsIn, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the code actions, fixes of findings first; only requested kinds if the request names some."""
    first, last = params.range.start.line, params.range.end.line
    found = workshop.findings(document, documents)
    near = (one for one in found if findings.touches(one.span, first, last))
    made = [action for one in near for action in findings.code_actions(one, document)]
    wanted = params.context.only if params.context is not None else None
    refactors = wanted is None or any(kind.startswith("refactor") for kind in wanted)
    if is_program(document) and refactors and not any(one.is_error for one in found):
        for make in _MADE:
            made += make(document, params, documents, workshop)
    return [one for one in made if wanted is None or _is_of(str(one["kind"]), wanted)]


def _is_of(kind: str, wanted: list[str]) -> bool:
    return any(kind == one or kind.startswith(f"{one}.") for one in wanted)
