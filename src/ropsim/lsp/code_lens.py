"""How long each task took in the last recorded run of exactly this program."""

from collections.abc import Mapping

from ropsim.language import Act, Role
from ropsim.lsp.document import Document
from ropsim.lsp.last_run import last_run
from ropsim.lsp.line_words import seconds
from ropsim.lsp.messages import Json
from ropsim.lsp.protocol import OfDocument
from ropsim.lsp.workshop import Workshop


def code_lenses(
    document: Document, _: OfDocument, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the times of each task that a recorded run called; none where no run fits the text."""
    run = last_run(document, documents, workshop)
    if run is None or not run.is_of_this_code:
        return []
    durations = run.program.durations
    return [
        {
            "range": document.range_of(use.span),
            "command": {"title": f"{seconds(durations[use.meaning.name])} {run.remark}", "command": ""},
        }
        for use in workshop.uses(document, documents).found
        if use.act is Act.DEFINES and use.meaning.role is Role.TASK and use.meaning.name in durations
    ]
