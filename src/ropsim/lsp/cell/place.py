"""Position in a cell file: section, key, and the question of its reader there."""

import re
from collections.abc import Mapping

from ropsim.cellfile import asked_in_cell_file
from ropsim.core import SourceText, Span, frozen_dataclass, toml_values
from ropsim.lsp.analysis.workshop import CELL_FILE, Surroundings
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.parameters import Position
from ropsim.tomltext import Path, Positions, Question, positions
from ropsim.workbench import robots_read


@frozen_dataclass
class Questions:
    """Questions of the reader of a cell file.

    Attributes:
        questions: by path.
        needed: paths of required entries.
    """

    questions: Mapping[Path, Question]
    needed: frozenset[Path]

    def keys_of(self, section: Path) -> Mapping[str, Question]:
        """Return the questions in a section, by key."""
        found = {path[-1]: one for path, one in self.questions.items() if path[:-1] == section}
        return {key: one for key, one in found.items() if isinstance(key, str)}


def is_cell_file(document: Document) -> bool:
    """Return whether a document is the cell file of a project."""
    path = document.path
    return path is not None and path.name == CELL_FILE


def questions_in(text: str, around: Surroundings) -> Questions:
    """Return the questions in a text of the cell file of a project."""
    return Questions(*asked_in_cell_file(SourceText(CELL_FILE, text), robots_read(around.robots)))


def places_in(document: Document) -> Positions | None:
    """Return where keys and values of a cell file stand, None where it is no TOML."""
    try:
        toml_values(document.text)
    except (ValueError, RecursionError):
        return None
    return positions(SourceText(document.name, document.text))


def path_at(document: Document, position: Position, places: Positions) -> Path | None:
    """Return the path of the key or value at a place, the innermost one; None for none."""
    line, column = position.line + 1, document.column(position) + 1
    found = [
        path
        for spans in (places.keys, places.values)
        for path, span in spans.items()
        if span.line == line and span.column <= column <= span.end_column
    ]
    return max(found, key=len, default=None)


def name_span(document: Document, span: Span, name: str) -> Span | None:
    """Return where a name stands in the span of its key, its header or its value; None where it does not."""
    text = document.line(span.line - 1)[span.column - 1 : span.end_column - 1]
    found = list(re.finditer(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text))
    if not found:
        return None
    return SourceText(document.name, document.text).span(
        span.line, span.column + found[-1].start(), len(name)
    )
