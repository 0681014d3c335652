"""Names that the cell file defines: all of them, their places in it, and the name at a place."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.cellfile import place_in_cell_file
from ropsim.core import Span
from ropsim.language import Act, Space
from ropsim.lsp.analysis.workshop import Surroundings
from ropsim.lsp.cell.place import is_cell_file, name_span, places_in, questions_in
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import Position

#: Tables of the cell file in which the names of a space are defined.
TABLES: Mapping[Space, tuple[str, ...]] = {
    Space.SYMBOL: ("locations", "signals"),
    Space.FRAME: ("frames",),
    Space.TOOL: ("tools",),
}


def names_of(around: Surroundings) -> Iterator[tuple[Space, str]]:
    """Yield the names that programs can use, with their space."""
    cell = around.cell
    if cell is None:
        return
    yield from ((Space.SYMBOL, name) for name in (*cell.locations, *cell.signals))
    yield from ((Space.FRAME, name) for name in cell.frames)
    tools = {name for station in cell.stations.values() for name in station.tools}
    yield from ((Space.TOOL, name) for name in sorted(tools))


def place_of(
    space: Space, name: str, around: Surroundings, document: Document, documents: Mapping[str, Document]
) -> Json | None:
    """Return the location of a name in the cell file around a document, None where it is not there."""
    text = around.cell_text
    if text is None or space not in TABLES:
        return None
    span = place_in_cell_file(text, name, TABLES[space])
    if span is None:
        return None
    cell = cell_document(around, document, documents)
    assert cell is not None
    return {"uri": cell.uri, "range": cell.range_of(span)}


def name_at(document: Document, position: Position, around: Surroundings) -> tuple[Space, str] | None:
    """Return the name that a place of the cell file defines or uses, None for any other place."""
    if not is_cell_file(document):
        return None
    line, column = position.line + 1, document.column(position) + 1
    for space, name in names_of(around):
        if name not in document.line(position.line):
            continue
        for _, span in uses_in_cell(document, space, name, around):
            if span.line == line and span.column <= column <= span.end_column:
                return space, name
    return None


def uses_in_cell(
    document: Document, space: Space, name: str, around: Surroundings
) -> Iterator[tuple[Act, Span]]:
    """Yield where a name stands in the cell file: where it is defined, then where other things name it."""
    places = places_in(document)
    if places is None:
        return
    for table in TABLES.get(space, ()):
        own = (table, name)
        span = name_span(document, places.keys[own], name) if own in places.keys else None
        if span is not None:
            yield Act.DEFINES, span
    questions = questions_in(document.text, around).questions
    sorts = {table[:-1] for table in TABLES.get(space, ())}
    for path in places.values:
        question = questions.get(path) or questions.get(path[:-1])
        if question is None or question.names not in sorts:
            continue
        value = places.values[path]
        text = document.line(value.line - 1)[value.column - 1 : value.end_column - 1]
        span = name_span(document, value, name) if text[1:-1] == name else None
        if span is not None:
            yield Act.READS, span


def cell_document(
    around: Surroundings, document: Document, documents: Mapping[str, Document]
) -> Document | None:
    """Return the cell file around a document, from the editor or the disk; None outside a project."""
    text = around.cell_text
    if text is None:
        return None
    place = Path(text.name)
    opened = (one for one in documents.values() if one.path == place)
    return next(opened, None) or Document(place.absolute().as_uri(), 0, text.text, document.encoding)
