"""All places that use the name at a place."""

from collections.abc import Mapping

from ropsim.language import Act
from ropsim.lsp.document import Document
from ropsim.lsp.found_name import found_name, locations_of
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import ReferencesAt
from ropsim.lsp.workshop import Workshop


def references(
    document: Document, params: ReferencesAt, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the places of a name, without those that define it where they are not asked for."""
    found = found_name(document, params.position, documents, workshop)
    if found is None:
        return []
    with_definition = params.context is None or params.context.include_declaration
    places = locations_of(document, found, documents, workshop)
    return [place for act, place in places if with_definition or act is not Act.DEFINES]
