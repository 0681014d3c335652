"""The last recorded run of exactly the program of a document, told by the lines that it has now."""

from collections.abc import Mapping
from itertools import chain

from ropsim.core import frozen_dataclass
from ropsim.lsp.document import Document
from ropsim.lsp.line_times import LineTimes
from ropsim.lsp.programs import is_program
from ropsim.lsp.recorded_runs import RecordedProgram, recordings_in
from ropsim.lsp.workshop import Workshop


@frozen_dataclass
class LastRun:
    """The last run of the program of a document.

    Attributes:
        program: what was recorded of it.
        lines: what is told of the lines of the document (from 1) that took time.
        is_of_this_cell: whether the cell has not changed since, as far as is known.
    """

    program: RecordedProgram
    lines: Mapping[int, LineTimes]
    is_of_this_cell: bool

    @property
    def remark(self) -> str:
        """Return where the times come from, in a few words."""
        return "in the last recorded run" + ("" if self.is_of_this_cell else ", before the cell changed")

    @property
    def mark(self) -> str:
        """Return what stands behind a time that may have become another one since; empty where none has."""
        return "" if self.is_of_this_cell else " (before the cell changed)"


def last_run(document: Document, documents: Mapping[str, Document], workshop: Workshop) -> LastRun | None:
    """Return the newest recorded run of the code that a document compiles to, None where there is none."""
    if not is_program(document):
        return None
    around = workshop.surroundings(document, documents)
    stamps = recordings_in(around.folder) if around.folder is not None else ()
    code = workshop.code_id(document, documents) if stamps else ""
    programs = chain.from_iterable(map(workshop.recorded, stamps))
    found = next((one for one in programs if code and one.icr_id == code), None)
    if found is None:
        return None
    then, now = found.code_lines, workshop.code_lines(document, documents)
    moved = dict(zip(then, now, strict=True)) if len(then) == len(now) else {}
    lines = {moved[line]: times for line, times in found.lines.items() if line in moved}
    is_of_this_cell = not found.cell or (around.cell is not None and around.cell.content == found.cell)
    return LastRun(found, lines, is_of_this_cell)
