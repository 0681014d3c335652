"""How long each task took in the last recorded run of exactly this program."""

from collections.abc import Mapping
from itertools import chain

from ropsim.language import Act, Role
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import OfDocument
from ropsim.lsp.recorded_runs import RecordedProgram, recordings_in
from ropsim.lsp.workshop import Workshop


def code_lenses(
    document: Document, _: OfDocument, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the times of each task that a recorded run called; none where no run fits the text."""
    run = _run(document, documents, workshop) if is_program(document) else None
    if run is None:
        return []
    return [
        {
            "range": document.range_of(use.span),
            "command": {"title": _told(run.durations[use.meaning.name]), "command": ""},
        }
        for use in workshop.uses(document, documents).found
        if use.act is Act.DEFINES and use.meaning.role is Role.TASK and use.meaning.name in run.durations
    ]


def _run(document: Document, documents: Mapping[str, Document], workshop: Workshop) -> RecordedProgram | None:
    """Return the newest recorded run of the code that a text compiles to."""
    folder = workshop.surroundings(document, documents).folder
    stamps = recordings_in(folder) if folder is not None else ()
    code = workshop.code_id(document, documents) if stamps else ""
    programs = chain.from_iterable(map(workshop.recorded, stamps))
    return next((one for one in programs if code and one.icr_id == code), None)


def _told(durations: tuple[float, ...]) -> str:
    shortest, longest, total = min(durations), max(durations), sum(durations)
    if len(durations) == 1:
        return f"{total:.2f} s in the last recorded run"
    each = f"{shortest:.2f} s" if longest - shortest < 0.005 else f"{shortest:.2f} to {longest:.2f} s"
    return f"{each}, {len(durations)} times, {total:.2f} s in the last recorded run"
