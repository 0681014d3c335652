"""Inlay hints of a program: types of its names, times of its lines and tasks in the last run."""

from collections.abc import Iterator, Mapping

from ropsim.language import Act, Role
from ropsim.lsp.analysis.last_run import LastRun, last_run
from ropsim.lsp.analysis.line_times import hint_words, line_words, seconds
from ropsim.lsp.analysis.programs import is_program
from ropsim.lsp.analysis.types_of import type_of_meaning
from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import InRange, OfDocument

_TYPE = 1


def inlay_hints(
    document: Document, params: InRange, documents: Mapping[str, Document], workshop: Workshop
) -> list[Json]:
    """Return the types of the names that some lines define without one, and the durations of these lines."""
    if not is_program(document):
        return []
    first, last = params.range.start.line, params.range.end.line
    uses = workshop.uses(document, documents)
    checked = workshop.checked(document, documents)
    hints: list[Json] = []
    for use in uses.found:
        if use.act is not Act.DEFINES or not first <= use.span.line - 1 <= last:
            continue
        if use.meaning.role not in (Role.VARIABLE, Role.PARAMETER):
            continue
        rest = document.line(use.span.line - 1)[use.span.end_column - 1 :].lstrip()
        type_ = type_of_meaning(use.meaning, uses, checked)
        if type_ and not (rest.startswith(":") and not rest.startswith(":=")):
            place = document.position(use.span.end_line - 1, use.span.end_column - 1)
            hints.append({"position": place, "label": f": {type_}", "kind": _TYPE})
    run = last_run(document, documents, workshop)
    return hints if run is None else [*hints, *_times(document, run, first, last)]


def _times(document: Document, run: LastRun, first: int, last: int) -> Iterator[Json]:
    """Yield the times of the lines from `first` to `last` (from 0), each at the end of its line."""
    for number, times in run.lines.items():
        if first <= number - 1 <= last and number <= len(document.starts):
            yield {
                "position": document.position(number - 1, len(document.line(number - 1).rstrip())),
                "label": hint_words(times) + run.mark,
                "tooltip": line_words(times, run.remark),
                "paddingLeft": True,
            }


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
