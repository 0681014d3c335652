"""Whether the recorded results of a line hold for the present text, by the content on which they depend."""

from collections.abc import Iterator, Mapping
from enum import StrEnum
from pathlib import Path

from ropsim.core import frozen_dataclass
from ropsim.lsp.analysis.programs import is_program, programs_of
from ropsim.lsp.analysis.recorded_runs import RecordedProgram, recordings_in
from ropsim.lsp.analysis.workshop import Surroundings, Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json, notification

METHOD = "ropsim/lineStates"


class LineState(StrEnum):
    """Whether the result of a line belongs to the present text.

    `valid`: it does. `stale`: the result belongs to another text. `none`: nothing was recorded.
    """

    VALID = "valid"
    STALE = "stale"
    NONE = "none"


@frozen_dataclass
class LineStatus:
    """A line on which the robot moves, grips or waits.

    Attributes:
        line: its number, from 1.
        state: of the recorded result.
        content: key of the content on which the result depends; empty while the text has errors.
    """

    line: int
    state: LineState
    content: str


def line_states(
    document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> tuple[LineStatus, ...]:
    """Return the lines of a program that have a result, in order; in a text with errors nothing is valid.

    In that case they are the contents of the last text without errors, as far as the lines are equal.
    """
    if not is_program(document):
        return ()
    recorded = tuple(recorded_of(document, documents, workshop))
    known = {key for one in recorded for key in one.results.values()}
    otherwise = LineState.STALE if recorded else LineState.NONE
    contents = contents_of(document, documents, workshop)
    if contents:
        states = {
            line: (LineState.VALID if key in known else otherwise, key) for line, key in contents.items()
        }
    else:
        states = dict.fromkeys(workshop.lines_before(document), (otherwise, ""))
    return tuple(LineStatus(line, *states[line]) for line in sorted(states))


def states_message(document: Document, documents: Mapping[str, Document], workshop: Workshop) -> Json:
    """Return the notification about the lines of a document."""
    states = line_states(document, documents, workshop)
    lines = [{"line": one.line - 1, "state": one.state.value, "content": one.content} for one in states]
    return notification(METHOD, {"uri": document.uri, "version": document.version, "lines": lines})


def contents_of(
    document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> Mapping[int, str]:
    """Return the keys of lines, see `icr.line_contents`; empty for a text with errors."""
    around = workshop.surroundings(document, documents)
    if around.is_broken:
        return {}
    others = tuple(_other_programs(document, around, documents, workshop))
    cell = around.cell
    content, channels = (cell.content, cell.input_changes) if cell is not None else ("", "")
    return workshop.line_contents(document, documents, (content, *others), channels)


def recorded_of(
    document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[RecordedProgram]:
    """Yield the recordings of the program of a document, of any version of its text, newest first."""
    around, path = workshop.surroundings(document, documents), document.path
    stamps = recordings_in(around.folder) if around.folder is not None else ()
    programs = workshop.recorded.programs(stamps)
    return (one for one in programs if path is not None and Path(one.source).name == path.name)


def _other_programs(
    document: Document, around: Surroundings, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[str]:
    """Yield the identities of the programs of the other stations of the cell."""
    cell = around.cell
    if cell is None or len(cell.stations) < 2:
        return
    own = next(iter(around.stations))
    others = {
        one.path.stem: one for one in programs_of(document, documents, workshop) if one.path is not None
    }
    for name, station in cell.stations.items():
        if name != own and station.program in others:
            yield workshop.code_id(others[station.program], documents)
