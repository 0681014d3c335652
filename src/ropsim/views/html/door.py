"""The way to the HTML report and to pages of responses, which are loaded when the first one is written."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ropsim.core import SourceText
from ropsim.flow import Recording
from ropsim.views.html.replay import NoReplay, Replay
from ropsim.views.summary.summary import Summary

if TYPE_CHECKING:
    from ropsim.views.comparison import Comparison
    from ropsim.views.loops.records import LoopPage


def html_report(
    recording: Recording,
    summary: Summary,
    sources: Mapping[str, SourceText],
    replay: Replay | NoReplay | None = None,
    comparison: "Comparison | None" = None,
) -> str:
    """Return the page.

    Args:
        recording: of the run.
        summary: its figures, from `summarize`.
        sources: program texts by the names that spans use, for quoting; may be empty.
        replay: of the run in 3-D, or why there is none; None says nothing about it.
        comparison: with runs in which something is changed; None for none.
    """
    from ropsim.views.html.report import html_report as written

    return written(recording, summary, sources, replay, comparison)


def response_page(page: "LoopPage") -> str:
    """Return responses and margins of loops as one HTML page that needs nothing else."""
    from ropsim.views.loops.page import response_page as written

    return written(page)
