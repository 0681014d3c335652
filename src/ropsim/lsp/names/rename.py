"""A name of a program changed at all its places, or the reason why it cannot be."""

import re
from collections.abc import Mapping

from ropsim.language import Space, Uses, uses_of
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.names import names_of
from ropsim.lsp.names.cell_rename import renamed_in_project, span_of_cell
from ropsim.lsp.names.found_name import FoundName, found_name
from ropsim.lsp.names.new_names import clash, keeps, renamed, unread, wrong
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json, Refusal
from ropsim.lsp.protocol.parameters import AtPosition, RenameAt

_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)


def prepare_rename(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | Refusal:
    """Return the place and text of the name at a place, or why it cannot have another one."""
    found = found_name(document, params.position, documents, workshop)
    if found is not None and found.is_of_cell:
        span = span_of_cell(document, params.position, found, workshop.named(document, documents))
        return {"range": document.range_of(span), "placeholder": found.name}
    if found is None or found.use is None:
        return Refusal(_nothing(document, params))
    refused = _fixed(document, found, workshop.uses(document, documents))
    return refused or {"range": document.range_of(found.use.span), "placeholder": found.name}


def rename(
    document: Document, params: RenameAt, documents: Mapping[str, Document], workshop: Workshop
) -> Json | Refusal:
    """Return the edits that rename a name at all its places, or why that cannot be.

    The new text is read once more: where one of its places would mean something else than before, the name is
    refused.
    """
    found = found_name(document, params.position, documents, workshop)
    if found is not None and found.is_of_cell:
        return renamed_in_project(document, found, params.new_name.strip(), documents, workshop)
    if found is None or found.use is None or found.meaning is None:
        return Refusal(_nothing(document, params))
    uses = workshop.uses(document, documents)
    new = params.new_name.strip()
    of_cell = frozenset(names_of(workshop.named(document, documents)))
    refused = _fixed(document, found, uses) or wrong(new, found) or clash(new, uses, of_cell)
    if refused is not None or new == found.name:
        return refused or {"changes": {}}
    places = [use.span for use in uses.of(found.meaning)]
    edits: list[Json] = [{"range": document.range_of(span), "newText": new} for span in places]
    outside = frozenset(name for space, name in of_cell if space is Space.SYMBOL)
    after = uses_of(renamed(document, uses, found, new), workshop.lines, outside)
    if not keeps(uses, after, found, new):
        return Refusal(f"with the name `{new}` a line would be read in another way")
    return {"changes": {document.uri: edits}}


def _nothing(document: Document, params: AtPosition) -> str:
    column = document.column(params.position)
    words = _WORD.finditer(document.line(params.position.line))
    word = next((one[0] for one in words if one.start() <= column <= one.end()), "")
    return f"`{word}` is no name of this text" if word else "no name stands here"


def _fixed(document: Document, found: FoundName, uses: Uses) -> Refusal | None:
    """Return why the name at a place cannot have another one."""
    meaning = found.meaning
    if meaning is not None and meaning.is_implicit:
        return Refusal(f"`{found.name}` is an implicit parameter, whose place follows from its name")
    if meaning is None or meaning.role is None:
        return Refusal(f"`{found.name}` is not defined")
    return unread(document, found, uses)
