"""Where a name is defined: in the text, or in the cell file."""

from collections.abc import Mapping

from ropsim.lsp.cell_names import place_of
from ropsim.lsp.document import Document
from ropsim.lsp.found_name import found_name
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import AtPosition
from ropsim.lsp.workshop import Workshop


def definition(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return the place where the name at a place is defined, None where nobody knows."""
    found = found_name(document, params.position, documents, workshop)
    if found is None:
        return None
    if found.meaning is not None and found.meaning.definition is not None:
        return {"uri": document.uri, "range": document.range_of(found.meaning.definition)}
    around = workshop.named(document, documents)
    return place_of(found.space, found.name, around, document, documents) if found.is_of_cell else None
