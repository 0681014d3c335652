"""What can be done about a stretch of a text: mend its findings."""

from collections.abc import Mapping

from ropsim.lsp import findings
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import InRange
from ropsim.lsp.workshop import Workshop


def actions(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return what can be done, fixes of findings first."""
    first, last = params.range.start.line, params.range.end.line
    found = workshop.checked(document, documents).diagnostics
    near = (one for one in found if findings.touches(one.span, first, last))
    return [action for one in near for action in findings.code_actions(one, document)]
