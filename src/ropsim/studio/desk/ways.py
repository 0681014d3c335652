"""The ways of the finished run: what met on them, looked at while nothing else is wanted."""

from dataclasses import asdict, replace
from functools import partial

from ropsim.simulation import with_collisions
from ropsim.studio.desk.finished import Shelf
from ropsim.studio.desk.line import Line
from ropsim.studio.jobs import WaysReply
from ropsim.views import result_figures, run_findings, summarize


def look_at_ways(number: int, line: Line, shelf: Shelf) -> WaysReply | None:
    """Return what is said of a run once its ways have been looked at; the kept run says it from then on.

    Args:
        number: of the job that made the run.
        line: to who asked.
        shelf: has the run.

    Returns:
        None where another run is kept meanwhile.

    Raises:
        Cancelled: it was given up.
    """
    kept = shelf.run
    if kept is None or kept.number != number:
        return None
    ready, recording = kept.ready, kept.recording
    if recording.facts.ways is None:
        found = ready.project.collisions(recording, partial(_listen, line))
        recording = with_collisions(recording, found)
        shelf.run = replace(kept, recording=recording)
    figures = result_figures(summarize(recording, ready.findings))
    return WaysReply(tuple(run_findings(recording, ready.findings)), asdict(figures))


def _listen(line: Line, share: float) -> None:
    """Go on, whatever share has been looked at, unless the look is given up."""
    del share
    line.orders(0.0)
