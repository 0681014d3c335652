"""The outline of a document as editors list it, and a search for declarations of all programs by name."""

from collections.abc import Mapping

from ropsim.language import Definition, Outline, Role
from ropsim.lsp.analysis.knowledge import task_symbols
from ropsim.lsp.analysis.programs import is_program, programs_of
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.cell.place import is_cell_file
from ropsim.lsp.cell.sections import cell_symbols
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import OfDocument, SymbolQuery

# Numbers of the protocol for the kinds of names.
KINDS = {
    Role.TASK: 12,
    Role.PARAMETER: 13,
    Role.LOCATION: 14,
    Role.FRAME: 3,
    Role.TOOL: 19,
    Role.SIGNAL: 24,
    Role.CONSTANT: 14,
    Role.VARIABLE: 13,
    Role.PATTERN: 18,
    Role.LIST: 18,
}


def symbols(document: Document, _: OfDocument, __: Mapping[str, Document], workshop: Workshop) -> list[Json]:
    """Return the tasks and declarations of a document in order of their place."""
    if document.is_task_text:
        return task_symbols(document)
    if is_cell_file(document):
        return cell_symbols(document)
    if not is_program(document):
        return []
    outline = workshop.outline(document)
    spans = {task.definition: task.span for task in outline.tasks}
    return [
        {
            "name": one.name,
            "detail": one.line[:120],
            "kind": KINDS[one.role],
            "range": document.range_of(spans.get(one, one.span)),
            "selectionRange": document.range_of(one.span),
        }
        for one in shown(outline)
    ]


def shown(outline: Outline) -> list[Definition]:
    """Return the definitions that lists show: tasks, and declarations outside of them."""
    return [one for one in outline.definitions if one.role is Role.TASK or _is_declared(one)]


def _is_declared(one: Definition) -> bool:
    """Return whether a name stands outside of tasks in a declaration of its own."""
    return not one.task and (one.role is not Role.VARIABLE or one.line[:4].lower() == "var ")


#: More are of no use in a list that is typed into.
MOST = 1000


def workspace_symbols(
    params: SymbolQuery, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the definitions in the projects of the open documents that match the query."""
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
