"""The places of one document that use the name under the cursor."""

from collections.abc import Mapping

from ropsim.language import Act
from ropsim.lsp.cell_names import uses_in_cell
from ropsim.lsp.document import Document
from ropsim.lsp.found_name import found_name, uses_in
from ropsim.lsp.messages import Json
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import AtPosition
from ropsim.lsp.workshop import Workshop

_READ, _WRITE = 2, 3


def highlights(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the places, told apart by whether they read or give a value."""
    found = found_name(document, params.position, documents, workshop)
    if found is None:
        return []
    if not is_program(document):
        around = workshop.named(document, documents)
        return [
            {"range": document.range_of(span), "kind": _READ if act is Act.READS else _WRITE}
            for act, span in uses_in_cell(document, found.space, found.name, around)
        ]
    return [
        {"range": document.range_of(use.span), "kind": _READ if use.act is Act.READS else _WRITE}
        for use in uses_in(document, found, documents, workshop)
    ]
