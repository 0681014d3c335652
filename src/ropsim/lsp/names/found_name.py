"""Meaning of the name at a place: in a program by its uses, in a cell file by its tables."""

from collections.abc import Iterator, Mapping

from ropsim.core import frozen_dataclass
from ropsim.language import Act, Meaning, Space, Use
from ropsim.lsp.analysis.programs import is_program, programs_of
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.names import cell_document, name_at, names_of, uses_in_cell
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import Position


@frozen_dataclass
class FoundName:
    """A name at a place.

    Attributes:
        space: name space of the name.
        name: as written.
        meaning: in the program; None in a cell file.
        use: the place in the program; None in a cell file.
        is_of_cell: whether the cell has it.
    """

    space: Space
    name: str
    meaning: Meaning | None
    use: Use | None
    is_of_cell: bool


def found_name(
    document: Document, position: Position, documents: Mapping[str, Document], workshop: Workshop
) -> FoundName | None:
    """Return the name at a place, None if there is none."""
    around = workshop.named(document, documents)
    if not is_program(document):
        named = name_at(document, position, around)
        return FoundName(*named, None, None, is_of_cell=True) if named is not None else None
    use = workshop.uses(document, documents).at(position.line + 1, document.column(position) + 1)
    if use is None:
        return None
    meaning = use.meaning
    of_cell = meaning.is_global and (meaning.space, meaning.name) in set(names_of(around))
    return FoundName(meaning.space, meaning.name, meaning, use, of_cell)


def uses_in(
    document: Document, found: FoundName, documents: Mapping[str, Document], workshop: Workshop
) -> tuple[Use, ...]:
    """Return the uses of a name in a program; one of the cell is known by its space there."""
    uses = workshop.uses(document, documents)
    if found.meaning is not None and not found.is_of_cell:
        return uses.of(found.meaning)
    return tuple(one for one in uses.found if _is_same(one.meaning, found))


def _is_same(meaning: Meaning, found: FoundName) -> bool:
    return meaning.is_global and (meaning.space, meaning.name) == (found.space, found.name)


def locations_of(
    document: Document, found: FoundName, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[tuple[Act, Json]]:
    """Yield all places of a name: of one of the cell in all programs of the project and in the cell file."""
    programs = programs_of(document, documents, workshop) if found.is_of_cell else (document,)
    for program in programs:
        for use in uses_in(program, found, documents, workshop):
            yield use.act, {"uri": program.uri, "range": program.range_of(use.span)}
    if found.is_of_cell:
        around = workshop.named(document, documents)
        cell = cell_document(around, document, documents)
        if cell is not None:
            for act, span in uses_in_cell(cell, found.space, found.name, around):
                yield act, {"uri": cell.uri, "range": cell.range_of(span)}
