"""Findings that likely follow from a move that was left out, so that they do not read like causes."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ropsim.core import Diagnostic, Span
from ropsim.flow import Event, GripEvent, MoveEvent, ReleaseEvent, SkipEvent
from ropsim.simulation.diagnostics.part_diagnostics import (
    NOT_AT_DESTINATION,
    NOTHING_GRASPED,
    RELEASED_IN_THE_AIR,
    RELEASED_INSIDE,
    WAITS_IN_VAIN,
)

_AT_HAND = {NOTHING_GRASPED.code, RELEASED_IN_THE_AIR.code, RELEASED_INSIDE.code}
"""Findings of grippers where an arm has not arrived."""

_AT_THE_END = {NOT_AT_DESTINATION.code, WAITS_IN_VAIN.code}
"""Findings at the end of a run."""


def with_causes(findings: Iterable[Diagnostic], events: Sequence[Event]) -> list[Diagnostic]:
    """Return the findings; consequences of an earlier line have it in their data.

    The keys are `follows_source` and `follows_line`. A finding of a gripper follows from a skipped move if
    its station has made no move since; a finding at the end of the run from the first skipped move; a part
    that is not at its destination otherwise from the first grip that took nothing.

    Args:
        findings: of a run.
        events: of the run, in order of time.
    """
    return [_with_cause(one, events) for one in findings]


def _with_cause(finding: Diagnostic, events: Sequence[Event]) -> Diagnostic:
    cause = _cause(finding, events)
    if cause is None:
        return finding
    data = {"follows_source": cause.source, "follows_line": cause.line}
    return replace(finding, data={**finding.data, **data})


def _cause(finding: Diagnostic, events: Sequence[Event]) -> Span | None:
    if finding.code in _AT_HAND:
        return _left_out_before(finding, events)
    if finding.code in _AT_THE_END:
        skipped = next((one for one in events if isinstance(one, SkipEvent)), None)
        empty = next((one for one in events if isinstance(one, GripEvent) and not one.part), None)
        first = skipped or (empty if finding.code == NOT_AT_DESTINATION.code else None)
        return first.span if first else None
    return None


def _left_out_before(finding: Diagnostic, events: Sequence[Event]) -> Span | None:
    """Return the place of the move of the same station that was left out last before a grip or a release."""
    station, visit = finding.data.get("station"), finding.data.get("pass")
    at = next(
        (
            k
            for k, one in enumerate(events)
            if isinstance(one, GripEvent | ReleaseEvent)
            and (one.span, one.visit) == (finding.span, visit)
            and station in {None, one.station}
        ),
        None,
    )
    if at is None:
        return None
    moves = (
        one
        for one in reversed(events[:at])
        if isinstance(one, MoveEvent | SkipEvent) and one.station == events[at].station
    )
    last = next(moves, None)
    return last.span if isinstance(last, SkipEvent) else None
