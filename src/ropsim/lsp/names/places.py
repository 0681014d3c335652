"""Where a name is defined, and all places that use it, in one document or in all."""

from collections.abc import Mapping

from ropsim.language import Act, Space
from ropsim.lsp.analysis.knowledge import place_of_task
from ropsim.lsp.analysis.names import word_at
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.names import place_of, uses_in_cell
from ropsim.lsp.names.found_name import found_name, locations_of, uses_in
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import AtPosition, ReferencesAt


def definition(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return the place where the name at a place is defined, None if unknown."""
    if document.is_task_text:
        tasks = workshop.surroundings(document, documents).tasks
        word = word_at(document, params.position)
        return place_of_task(word[0], tasks, document, documents) if word is not None else None
    found = found_name(document, params.position, documents, workshop)
    if found is None:
        return None
    if found.meaning is not None and found.meaning.definition is not None:
        return {"uri": document.uri, "range": document.range_of(found.meaning.definition)}
    around = workshop.named(document, documents)
    if found.space is Space.TASK:
        return place_of_task(found.name, around.tasks, document, documents)
    return place_of(found.space, found.name, around, document, documents) if found.is_of_cell else None


def references(
    document: Document, params: ReferencesAt, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the places of a name; its definitions only if they are requested."""
    found = found_name(document, params.position, documents, workshop)
    if found is None:
        return []
    with_definition = params.context is None or params.context.include_declaration
    places = locations_of(document, found, documents, workshop)
    return [place for act, place in places if with_definition or act is not Act.DEFINES]


_READ, _WRITE = 2, 3


def highlights(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the places, distinguished by reading and writing access."""
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
