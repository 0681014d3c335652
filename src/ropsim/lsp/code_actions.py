"""What can be done about lines: mend findings, write types, name locations, change moves, make tasks."""

from collections.abc import Mapping

from ropsim.lsp import findings
from ropsim.lsp.document import Document
from ropsim.lsp.extract_task import extract_task
from ropsim.lsp.messages import Json
from ropsim.lsp.name_location import name_location
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import ActionsIn
from ropsim.lsp.way_of_move import way_of_move
from ropsim.lsp.workshop import Workshop
from ropsim.lsp.write_types import write_types

#: The kinds of what is offered.
KINDS = ("quickfix", "refactor.rewrite", "refactor.extract")

_MADE = (write_types, name_location, way_of_move, extract_task)


def actions(
    document: Document, params: ActionsIn, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return what can be done, fixes of findings first; of the kinds that are asked for, where some are."""
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
