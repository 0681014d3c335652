"""A plan that was made for moves on other lines of a text."""

from collections.abc import Mapping
from dataclasses import replace

from ropsim.core import Diagnostic, Label, Span
from ropsim.flow import MoveInstruction
from ropsim.simulation.records.planned_sequence import PlannedSequence

Moves = tuple[MoveInstruction, ...]
Spans = Mapping[Span | None, Span | None]


def on_lines_of(moves: Moves, before: Moves, planned: PlannedSequence) -> PlannedSequence | None:
    """Return a plan with its findings on the lines of other moves of the same content.

    Args:
        moves: that are to be made.
        before: those for which it was made.
        planned: the plan.

    Returns:
        the plan; None if the present line of a finding is unknown.
    """
    if all(one.origin == other.origin for one, other in zip(moves, before, strict=True)):
        return planned
    spans: dict[Span | None, Span | None] = {}
    for one, other in zip(moves, before, strict=True):
        if spans.setdefault(other.origin.span, one.origin.span) != one.origin.span:
            return None
    motion, refusal = planned.motion, planned.refusal
    all_findings = (*(motion.plan.findings if motion else ()), *(refusal.diagnostics if refusal else ()))
    if not all(_can_move(one, spans) for one in all_findings):
        return None
    if motion:
        made = tuple(replace(one, move=move) for one, move in zip(motion.plan.moves, moves, strict=False))
        findings = _moved(motion.plan.findings, spans)
        motion = replace(motion, plan=replace(motion.plan, moves=made, findings=findings))
    if refusal:
        refusal = replace(refusal, diagnostics=_moved(refusal.diagnostics, spans))
    return PlannedSequence(motion, refusal)


def _can_move(finding: Diagnostic, spans: Spans) -> bool:
    """Return whether a finding stands on moves, and nowhere else."""
    places = (finding.span, *(label.span for label in finding.secondary))
    return all(place in spans for place in places) and finding.fix is None


def _moved(findings: tuple[Diagnostic, ...], spans: Spans) -> tuple[Diagnostic, ...]:
    return tuple(_onto(one, spans) for one in findings)


def _onto(finding: Diagnostic, spans: Spans) -> Diagnostic:
    labels = [(spans[label.span], label.text) for label in finding.secondary]
    return replace(
        finding,
        span=spans[finding.span],
        secondary=tuple(Label(span, text) for span, text in labels if span is not None),
    )
