"""The collisions of the finished run, checked while no other job waits."""

from dataclasses import asdict, replace
from functools import partial

from ropsim.studio.desk.finished import Shelf
from ropsim.studio.desk.line import Line
from ropsim.studio.wire.replies import WaysReply
from ropsim.views import result_figures, run_findings, summarize


def look_at_ways(number: int, line: Line, shelf: Shelf) -> WaysReply | None:
    """Return the collisions of a run; the kept run has them from then on.

    Args:
        number: of the job that made the run.
        line: connection to the sender.
        shelf: has the run.

    Returns:
        None where another run is kept meanwhile.

    Raises:
        Cancelled: it was given up.
    """
    kept = shelf.run
    if kept is None or kept.number != number:
        return None
    ready = kept.ready
    recording = ready.project.checked(kept.recording, partial(_listen, line))
    shelf.run = replace(kept, recording=recording)
    figures = result_figures(summarize(recording, ready.findings))
    ways = recording.facts.ways
    return WaysReply(
        tuple(run_findings(recording, ready.findings)), asdict(figures), asdict(ways) if ways else None
    )


def _listen(line: Line, share: float) -> None:
    """Go on, regardless of the share checked, unless the check is given up."""
    del share
    line.orders(0.0)
