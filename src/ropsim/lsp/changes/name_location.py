"""Changes that write something down: a name for a location given as numbers, and the types of parameters."""

import re
from collections.abc import Iterator, Mapping

from ropsim.core import SourceText, Span
from ropsim.language import Act, Role, Uses, literals_on
from ropsim.lsp.analysis.same_code import has_same_code
from ropsim.lsp.analysis.types_of import type_of_meaning
from ropsim.lsp.analysis.workshop import Surroundings, Workshop
from ropsim.lsp.cell.names import names_of
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.edits import Change, action, applied, refused
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import InRange

TITLE = "name this location"
KIND = "refactor.extract"

_HEAD = re.compile(r"\s*(?:program|units|classic|strict)\b", re.IGNORECASE)
_DECLARED = (Role.LOCATION, Role.FRAME, Role.CONSTANT, Role.PATTERN, Role.SIGNAL, Role.TOOL)


def name_location(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[Json]:
    """Yield the change for the location at a place; where the code would not be the same, the reason."""
    line, column = params.range.start.line + 1, document.column(params.range.start) + 1
    source = SourceText(document.name, document.text)
    spans = literals_on(source, line, workshop.lines)
    at = [one for one in spans if one.column <= column <= one.end_column]
    if not at:
        return
    around = workshop.named(document, documents)
    name = free_name("place", workshop.uses(document, documents), around)
    for span in at:
        changes = _changes(document, span, name, workshop)
        if has_same_code(document, applied(document, changes), around, workshop):
            yield action(f"{TITLE} `{name}`", KIND, document, changes)
            return
    reason = "as a declaration it would not be the same: it needs names or a frame of its own place"
    yield refused(TITLE, KIND, reason)


def free_name(stem: str, uses: Uses, around: Surroundings) -> str:
    """Return a name that neither text nor cell has."""
    taken = {one.name for one in uses.meanings()} | {name for _, name in names_of(around)}
    return next(f"{stem}{number}" for number in range(1, len(taken) + 2) if f"{stem}{number}" not in taken)


def _changes(document: Document, span: Span, name: str, workshop: Workshop) -> list[Change]:
    line = document.line(span.line - 1)
    literal = line[span.column - 1 : span.end_column - 1]
    number = _place(document, workshop)
    begin = "" if number < len(document.starts) else "\n"
    return [
        Change(number, 0, number, 0, f"{begin}loc {name} = {literal}\n"),
        Change(span.line - 1, span.column - 1, span.end_line - 1, span.end_column - 1, name),
    ]


def _place(document: Document, workshop: Workshop) -> int:
    """Return the line (from 0) behind the last declaration."""
    heads = [number for number in range(len(document.starts)) if _HEAD.match(document.line(number))]
    declared = [
        one.span.line - 1 + one.line.count("\n")
        for one in workshop.outline(document).definitions
        if not one.task and one.role in _DECLARED
    ]
    return max((*heads, *declared), default=-1) + 1


def write_types(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[Json]:
    """Yield the change of each header that some lines touch and that leaves types open."""
    first, last = params.range.start.line + 1, params.range.end.line + 1
    uses = workshop.uses(document, documents)
    checked = workshop.checked(document, documents)
    touched = {name for name, line, _ in uses.tasks if first <= line <= last}
    changes: dict[str, list[Change]] = {}
    for use in uses.found:
        meaning = use.meaning
        if use.act is not Act.DEFINES or meaning.role is not Role.PARAMETER or meaning.task not in touched:
            continue
        rest = document.line(use.span.end_line - 1)[use.span.end_column - 1 :].lstrip()
        type_ = type_of_meaning(meaning, uses, checked)
        if type_ and not (rest.startswith(":") and not rest.startswith(":=")):
            line, column = use.span.end_line - 1, use.span.end_column - 1
            changes.setdefault(meaning.task, []).append(Change(line, column, line, column, f": {type_}"))
    around = workshop.surroundings(document, documents)
    for task, made in changes.items():
        if has_same_code(document, applied(document, made), around, workshop):
            yield action(f"write the types of `{task}`", "refactor.rewrite", document, made)
