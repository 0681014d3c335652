"""The outline of a document, as editors list it."""

from ropsim.language import Definition, Role
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.workshop import Workshop

_KINDS = {
    Role.TASK: 12,
    Role.PARAMETER: 13,
    Role.LOCATION: 14,
    Role.FRAME: 3,
    Role.TOOL: 19,
    Role.SIGNAL: 24,
    Role.CONSTANT: 14,
    Role.VARIABLE: 13,
    Role.PATTERN: 18,
}


def symbols(document: Document, workshop: Workshop) -> list[Json]:
    """Return the tasks and declarations of a document in order of their place."""
    if document.name.endswith((".toml", ".icr")):
        return []
    outline = workshop.outline(document)
    spans = {task.definition: task.span for task in outline.tasks}
    shown = [one for one in outline.definitions if one.role is Role.TASK or _is_declared(one)]
    return [
        {
            "name": one.name,
            "detail": one.line[:120],
            "kind": _KINDS[one.role],
            "range": document.range_of(spans.get(one, one.span)),
            "selectionRange": document.range_of(one.span),
        }
        for one in shown
    ]


def _is_declared(one: Definition) -> bool:
    """Return whether a name stands outside of tasks in a declaration of its own."""
    return not one.task and (one.role is not Role.VARIABLE or one.line[:4].lower() == "var ")
