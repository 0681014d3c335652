"""Types that a program does not write: of variables at their first value, of parameters in their header."""

from collections.abc import Mapping

from ropsim.language import Act, Role
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import InRange
from ropsim.lsp.types_of import type_of_meaning
from ropsim.lsp.workshop import Workshop

_TYPE = 1


def inlay_hints(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the types of the names that some lines define without one."""
    if not is_program(document):
        return []
    first, last = params.range.start.line, params.range.end.line
    uses = workshop.uses(document, documents)
    checked = workshop.checked(document, documents)
    hints: list[Json] = []
    for use in uses.found:
        if use.act is not Act.DEFINES or not first <= use.span.line - 1 <= last:
            continue
        if use.meaning.role not in (Role.VARIABLE, Role.PARAMETER):
            continue
        rest = document.line(use.span.line - 1)[use.span.end_column - 1 :].lstrip()
        type_ = type_of_meaning(use.meaning, uses, checked)
        if type_ and not (rest.startswith(":") and not rest.startswith(":=")):
            place = document.position(use.span.end_line - 1, use.span.end_column - 1)
            hints.append({"position": place, "label": f": {type_}", "kind": _TYPE})
    return hints
