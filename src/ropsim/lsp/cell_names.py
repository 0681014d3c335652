"""Names that the cell file gives: which there are, where they stand in it, which one stands at a place."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.cellfile import place_in_cell_file
from ropsim.core import SourceText
from ropsim.language import Space
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import Position
from ropsim.lsp.workshop import CELL_FILE, Surroundings

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
    place = Path(text.name)
    opened = (one for one in documents.values() if one.path == place)
    cell = next(opened, None) or Document(place.absolute().as_uri(), 0, text.text, document.encoding)
    return {"uri": cell.uri, "range": cell.range_of(span)}


def name_at(document: Document, position: Position, around: Surroundings) -> tuple[Space, str] | None:
    """Return the name that a place of the cell file defines, None for any other place."""
    path = document.path
    if path is None or path.name != CELL_FILE:
        return None
    line, column = position.line + 1, document.column(position) + 1
    text = SourceText(document.name, document.text)
    for space, name in names_of(around):
        if name not in document.line(position.line):
            continue
        span = place_in_cell_file(text, name, TABLES[space])
        if span is not None and span.line == line and span.column <= column <= span.end_column:
            return space, name
    return None
