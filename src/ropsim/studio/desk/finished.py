"""The run that the worker has made last: to be shown on other lines, or to be kept as files."""

from dataclasses import dataclass, replace
from enum import Enum

from ropsim import icr
from ropsim.core import frozen_dataclass
from ropsim.flow import Recording
from ropsim.model import Cell
from ropsim.records import inputs_of, inputs_text, recording_bytes
from ropsim.simulation import KeptRuns
from ropsim.studio.desk.content import moved_lines, on_lines
from ropsim.studio.desk.runnable import Runnable
from ropsim.studio.wire.jobs import Cause, RunForm
from ropsim.studio.wire.replies import SavedRun


class Origin(Enum):
    """How a run came about."""

    SIMULATED = "simulated"
    LIVE = "live"


@frozen_dataclass
class FinishedRun:
    """A run with its recording.

    Attributes:
        number: of the job that made it, or has shown it on other lines since.
        content: key of its content.
        ready: the compiled program.
        recording: its recording.
        origin: how it came about; a live run may have been held, slowed and ended by hand.
        beside: content of later texts for which the run stays the result; empty for none.
    """

    number: int
    content: str
    ready: Runnable
    recording: Recording
    origin: Origin = Origin.SIMULATED
    beside: str = ""

    def is_result_of(self, content: str, cause: Cause) -> bool:
        """Return whether no simulation is needed: a live run does not satisfy a request for a simulation."""
        return content == self.content and (self.origin is Origin.SIMULATED or cause != "asked")

    def stays_beside(self, content: str, cause: Cause) -> bool:
        """Return whether the run stays the result of texts that say something else."""
        return cause == "text_beside_live" or (cause == "text" and content == self.beside)

    def shown_on(self, number: int, ready: Runnable) -> "FinishedRun":
        """Return the same run for another text of the same content.

        Args:
            number: of the requesting job.
            ready: compiled from that text.
        """
        recording = self.recording
        for station, code in self.ready.codes.items():
            lines = moved_lines(code, ready.codes[station])
            recording = on_lines(recording, code.source, lines)
        return replace(self, number=number, ready=ready, recording=recording, beside="")

    def file(self, form: RunForm) -> SavedRun:
        """Return the run as a file."""
        match form:
            case "recording":
                return SavedRun(recording_bytes(self.recording))
            case "inputs":
                return SavedRun(inputs_text(inputs_of(self.recording)))
            case "report":
                report = self.ready.project.report(self.recording, self.ready.findings)
                return SavedRun(report.html().encode("utf-8", "replace"))
            case "code":
                return SavedRun(icr.disassemble(self.ready.code).encode("utf-8", "replace"))


@dataclass(slots=True)
class Shelf:
    """The newest finished run, and results computed for it.

    Attributes:
        run: None before the first.
        known: of runs in the newest cell, None before the first.
    """

    run: FinishedRun | None = None
    known: KeptRuns | None = None

    def known_in(self, cell: Cell) -> KeptRuns:
        """Return the kept results of runs in a cell, for a new one."""
        if self.known is None or self.known.cell != cell:
            self.known = KeptRuns(cell)
        self.known.begin()
        return self.known
