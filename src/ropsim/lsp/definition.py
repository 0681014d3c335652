"""Where a name is defined: in the text, in the cell file, or in a text of tasks."""

from collections.abc import Mapping

from ropsim.language import Space
from ropsim.lsp.cell_names import place_of
from ropsim.lsp.document import Document
from ropsim.lsp.found_name import found_name
from ropsim.lsp.knowledge import place_of_task
from ropsim.lsp.messages import Json
from ropsim.lsp.names import word_at
from ropsim.lsp.protocol import AtPosition
from ropsim.lsp.workshop import Workshop


def definition(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return the place where the name at a place is defined, None where nobody knows."""
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
