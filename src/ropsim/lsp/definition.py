"""Where a name is defined: in the text, or in the cell file."""

from collections.abc import Mapping
from pathlib import Path

from ropsim.cellfile import place_in_cell_file
from ropsim.core import SourceText
from ropsim.lsp import names
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import Position
from ropsim.lsp.workshop import Workshop


def definition(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return the place where the name at a place is defined, None where nobody knows."""
    found = names.word_at(document, position)
    if found is None or document.name.endswith((".toml", ".icr")):
        return None
    word, _ = found
    outline = workshop.outline(document)
    tasks = (task.definition for task in outline.tasks if task.definition.name == word)
    defined = names.definition_of(outline, word, position.line) or next(tasks, None)
    if defined is not None:
        return {"uri": document.uri, "range": document.range_of(defined.span)}
    text = workshop.surroundings(document, documents).cell_text
    return _in_cell(word, text, documents) if text is not None else None


def _in_cell(word: str, text: SourceText, documents: Mapping[str, Document]) -> Json | None:
    span = place_in_cell_file(text, word)
    if span is None:
        return None
    place = Path(text.name)
    opened = (one for one in documents.values() if one.path == place)
    cell = next(opened, None) or Document(place.absolute().as_uri(), 0, text.text)
    return {"uri": cell.uri, "range": cell.range_of(span)}
