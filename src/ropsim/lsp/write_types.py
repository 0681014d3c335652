"""Writes the types of parameters into the header of a task, as their use tells them."""

from collections.abc import Iterator, Mapping

from ropsim.language import Act, Role
from ropsim.lsp.document import Document
from ropsim.lsp.edits import Change, action, applied
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import InRange
from ropsim.lsp.same_code import has_same_code
from ropsim.lsp.types_of import type_of_meaning
from ropsim.lsp.workshop import Workshop


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
