"""Tasks and declarations of all programs by a part of their name."""

from collections.abc import Mapping

from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.programs import programs_of
from ropsim.lsp.protocol import SymbolQuery
from ropsim.lsp.symbols import KINDS, shown
from ropsim.lsp.workshop import Workshop

#: More are of no use in a list that is typed into.
MOST = 1000


def workspace_symbols(
    params: SymbolQuery, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return what is defined in the projects of the open documents and has the letters asked for."""
    programs = {
        program.uri: program
        for document in documents.values()
        for program in programs_of(document, documents, workshop)
    }
    found: list[Json] = [
        {
            "name": one.name,
            "kind": KINDS[one.role],
            "location": {"uri": uri, "range": program.range_of(one.span)},
            **({"containerName": program.path.stem} if program.path is not None else {}),
        }
        for uri, program in sorted(programs.items())
        for one in shown(workshop.outline(program))
        if _has_letters(one.name.lower(), params.query.lower())
    ]
    return found[:MOST]


def _has_letters(name: str, query: str) -> bool:
    """Return whether the letters of a query stand in a name in their order."""
    rest = iter(name)
    return all(letter in rest for letter in query)
