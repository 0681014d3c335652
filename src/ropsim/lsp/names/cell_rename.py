"""A name of the cell changed at all its places: in the cell file, and in all programs of the project."""

import re
from collections.abc import Mapping
from dataclasses import replace

from ropsim.core import Span
from ropsim.language import Space, uses_of
from ropsim.lsp.analysis.programs import programs_of
from ropsim.lsp.analysis.workshop import Surroundings, Workshop
from ropsim.lsp.cell.names import cell_document, names_of, uses_in_cell
from ropsim.lsp.names.found_name import FoundName, uses_in
from ropsim.lsp.names.new_names import clash, keeps, renamed, unread, wrong
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json, Refusal
from ropsim.lsp.protocol.parameters import Position


def span_of_cell(
    document: Document, position: Position, found: FoundName, around: Surroundings
) -> Span | None:
    """Return where the name of the cell at a place of a program or of the cell file stands."""
    if found.use is not None:
        return found.use.span
    line, column = position.line + 1, document.column(position) + 1
    spans = (span for _, span in uses_in_cell(document, found.space, found.name, around))
    at = (span for span in spans if span.line == line and span.column <= column <= span.end_column)
    return next(at, None)


def renamed_in_project(
    document: Document, found: FoundName, new: str, documents: Mapping[str, Document], workshop: Workshop
) -> Json | Refusal:
    """Return the edits that rename a name of the cell, or why that cannot be.

    Every program that names it is read once more with the new name: it must use all names as before.
    """
    around = workshop.surroundings(document, documents)
    cell = cell_document(around, document, documents)
    if around.cell is None or cell is None:
        return Refusal("cell.toml has mistakes: mend them first")
    if new == found.name:
        return {"changes": {}}
    refused = wrong(new, found) or _in_tasks(found.name, around)
    if refused is not None:
        return refused
    spans = [span for _, span in uses_in_cell(cell, found.space, found.name, around)]
    changes = {cell.uri: [_edit(cell, span, new) for span in spans]}
    of_cell = frozenset(names_of(around))
    outside = {name for space, name in of_cell if space is Space.SYMBOL}
    if found.space is Space.SYMBOL:
        outside = (outside - {found.name}) | {new}
    if any(name == new for _, name in of_cell):
        return Refusal(f"the cell has the name `{new}`")
    for program in programs_of(document, documents, workshop):
        uses = workshop.uses(program, documents)
        refused = unread(program, found, uses)
        if refused is not None:
            return Refusal(f"{program.name}: {refused.message}")
        places = uses_in(program, found, documents, workshop)
        if not places:
            continue
        refused = clash(new, uses, frozenset())
        if refused is not None:
            return Refusal(f"{program.name}: {refused.message}")
        own = replace(found, meaning=places[0].meaning)
        after = uses_of(renamed(program, uses, own, new), workshop.lines, frozenset(outside))
        if not keeps(uses, after, own, new):
            words = f"{program.name}: with the name `{new}` a line would be read in another way"
            return Refusal(words)
        changes[program.uri] = [_edit(program, use.span, new) for use in places]
    return {"changes": changes}


def _edit(document: Document, span: Span, new: str) -> Json:
    return {"range": document.range_of(span), "newText": new}


def _in_tasks(name: str, around: Surroundings) -> Refusal | None:
    """Return a text of tasks that may use the name: its meaning there cannot be determined from the words."""
    word = re.compile(rf"\b{re.escape(name)}\b")
    for text in around.tasks.own:
        for number, line in enumerate(text.lines, 1):
            if word.search(line):
                return Refusal(
                    f"{text.name}, line {number}, may name `{name}`: change it there by hand first"
                )
    return None
