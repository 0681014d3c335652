"""The last recorded run of exactly the program of a document, by its present lines."""

from collections.abc import Mapping
from itertools import takewhile

from ropsim.core import frozen_dataclass
from ropsim.lsp.analysis.line_states import contents_of, recorded_of
from ropsim.lsp.analysis.line_times import LineTimes
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.recorded_runs import RecordedProgram, recordings_in
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.document import Document


@frozen_dataclass
class LastRun:
    """The last run of the program of a document.

    Attributes:
        program: the recorded program.
        lines: results of the lines of the document (from 1) that took time.
        is_of_this_cell: whether the cell has not changed since, as far as is known.
        is_of_this_code: whether the program still has its recorded behaviour; else `lines` holds the lines up
            to the first one that differs.
    """

    program: RecordedProgram
    lines: Mapping[int, LineTimes]
    is_of_this_cell: bool
    is_of_this_code: bool = True

    @property
    def remark(self) -> str:
        """Return where the times come from, in a few words."""
        if not self.is_of_this_code:
            return "in the last recorded run, whose program was the same up to here"
        return "in the last recorded run" + ("" if self.is_of_this_cell else ", before the cell changed")

    @property
    def mark(self) -> str:
        """Return the mark behind a time that may be outdated; empty if none is."""
        return "" if self.is_of_this_cell else " (before the cell changed)"


def last_run(document: Document, documents: Mapping[str, Document], workshop: Workshop) -> LastRun | None:
    """Return the newest recorded run of the code that a document compiles to.

    If there is none, it is the newest recording of the program in which some lines have their present
    behaviour; None if no run qualifies.
    """
    if not is_program(document):
        return None
    around = workshop.surroundings(document, documents)
    stamps = recordings_in(around.folder) if around.folder is not None else ()
    code = workshop.code_id(document, documents) if stamps else ""
    programs = workshop.recorded.programs(stamps)
    found = next((one for one in programs if code and one.icr_id == code), None)
    if found is None:
        return _up_to_a_change(document, documents, workshop)
    then, now = found.code_lines, workshop.code_lines(document, documents)
    moved = dict(zip(then, now, strict=True)) if len(then) == len(now) else {}
    lines = {moved[line]: times for line, times in found.lines.items() if line in moved}
    is_of_this_cell = not found.cell or (around.cell is not None and around.cell.content == found.cell)
    return LastRun(found, lines, is_of_this_cell)


def _up_to_a_change(
    document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> LastRun | None:
    """Return the newest run of which the text leaves some lines valid, with these."""
    recorded = tuple(recorded_of(document, documents, workshop))
    now = tuple(contents_of(document, documents, workshop).items()) if recorded else ()
    for one in recorded:
        passed = zip(one.results.items(), now, strict=False)
        same = takewhile(lambda pair: pair[0][1] == pair[1][1], passed)
        lines = {line: one.lines[then] for (then, _), (line, _) in same if then in one.lines}
        if lines:
            return LastRun(one, lines, is_of_this_cell=True, is_of_this_code=False)
    return None
