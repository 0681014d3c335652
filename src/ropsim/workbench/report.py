"""The report of a recording: terminal text, HTML page, summary."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ropsim.core import SourceText, replace_file
from ropsim.flow import Recording
from ropsim.views import Style, Summary, html_report, summarize, terminal_report


@dataclass(frozen=True, slots=True)
class Report:
    """A report; everything in it is derived from the recording.

    Attributes:
        recording: of the run.
        summary: its key figures.
        sources: program texts for quoting, by the names that spans use.
    """

    recording: Recording
    summary: Summary
    sources: Mapping[str, SourceText]

    @classmethod
    def of(cls, recording: Recording, sources: Mapping[str, SourceText]) -> "Report":
        """Return the report of a recording; it is summarized once."""
        return cls(recording, summarize(recording), sources)

    def text(self, style: Style = Style.PLAIN) -> str:
        """Return the report for a terminal."""
        return terminal_report(self.summary, style)

    def html(self) -> str:
        """Return the self-contained HTML page."""
        return html_report(self.recording, self.summary, self.sources)

    def save(self, path: str | Path) -> None:
        """Write the HTML page; an older file is replaced in one step.

        Raises:
            OSError: the place cannot be written.
        """
        replace_file(Path(path), self.html().encode())
