"""The run that the worker has made last: to be shown on other lines, or to be kept as files."""

from dataclasses import dataclass

from ropsim import icr
from ropsim.core import frozen_dataclass
from ropsim.flow import Recording
from ropsim.records import inputs_of, inputs_text, recording_bytes
from ropsim.studio.desk.content import moved_lines, on_lines
from ropsim.studio.desk.runnable import Runnable
from ropsim.studio.jobs import RunForm, SavedRun


@frozen_dataclass
class FinishedRun:
    """A run with its recording.

    Attributes:
        number: of the job that made it, or has shown it on other lines since.
        content: what it is a run of; empty where no other run is the same.
        ready: the program, as it was compiled.
        recording: what it has left.
    """

    number: int
    content: str
    ready: Runnable
    recording: Recording

    def shown_on(self, number: int, ready: Runnable) -> "FinishedRun":
        """Return the same run for another text of the same content.

        Args:
            number: of the job that asks for it.
            ready: compiled from that text.
        """
        recording = self.recording
        for station, code in self.ready.codes.items():
            lines = moved_lines(code, ready.codes[station])
            recording = on_lines(recording, code.source, lines)
        return FinishedRun(number, self.content, ready, recording)

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
    """Where the newest finished run is kept; None before the first."""

    run: FinishedRun | None = None
