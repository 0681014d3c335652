"""Plans for moves that stand on other lines now, and plans for as many moves of which fewer are made."""

from dataclasses import replace

import pytest

from ropsim.core import Diagnostic, Label, Span, TextEdit
from ropsim.flow import MoveInstruction, Origin
from ropsim.model import Payload
from ropsim.motion import JOINT_LIMIT_ON_LINE
from ropsim.planning import MotionSequence, Refusal
from ropsim.simulation import KeptPlans
from ropsim.simulation.testing import PlannedSequence, on_lines_of
from support.cells import one_station
from support.motion import CHAIN, PUMA, START, interface_pose, lin, ptp, shifted

FIRST = interface_pose(START)
MOVES = (ptp(FIRST), lin(shifted(FIRST, 0.0, 0.0, 0.05)))


def span(line: int) -> Span:
    return Span.on_line("a.task", line, 9)


def on(*lines: int) -> tuple[MoveInstruction, ...]:
    return tuple(replace(move, origin=Origin(span(line))) for move, line in zip(MOVES, lines, strict=True))


def refused(place: Span, marked: Span, fix: TextEdit | None = None) -> PlannedSequence:
    return PlannedSequence(None, Refusal((found(place, marked, fix),)))


def found(place: Span, marked: Span, fix: TextEdit | None = None) -> Diagnostic:
    return JOINT_LIMIT_ON_LINE.at(place, "it is", secondary=(Label(marked, "here"),), fix=fix)


def test_findings_stand_on_the_lines_of_the_moves() -> None:
    told = refused(span(5), span(4))
    assert on_lines_of(on(4, 5), on(4, 5), told) is told
    assert on_lines_of(on(6, 9), on(4, 5), told) == refused(span(9), span(6))


@pytest.mark.parametrize(
    "told",
    [
        refused(span(5), span(3)),
        refused(span(3), span(4)),
        refused(span(5), span(4), TextEdit(span(5), "lin")),
    ],
)
def test_what_stands_elsewhere_or_changes_the_text_is_planned_anew(told: PlannedSequence) -> None:
    assert on_lines_of(on(6, 9), on(4, 5), told) is None


def test_moves_of_one_line_that_stand_on_two_now_are_planned_anew() -> None:
    assert on_lines_of(on(6, 9), on(4, 4), refused(span(4), span(4))) is None


def test_a_move_that_is_only_looked_at_is_no_move_of_the_stretch() -> None:
    plans = KeptPlans(one_station("c", PUMA, CHAIN.controller))
    moves = on(4, 5)
    for made in (2, 1, 2, 1):
        planned = plans.plan("left", CHAIN, MotionSequence(moves[:made], START, Payload(), moves[made:]))
        assert planned.motion is not None
        assert len(planned.motion.plan.moves) == made
    assert len(plans.anew) == 2
