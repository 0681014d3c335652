"""The program of paper 1, Fig. 5, exactly as printed."""

from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim import icr
from ropsim.flow import GripAction, MotionKind, Recording
from ropsim.spatial import Pose

FIG5 = Path(__file__).parents[2] / "examples" / "fig5"
#: Rounding of repeated additions of 0.1 cm.
ROUNDING = 1e-12


@pytest.fixture(scope="module")
def trace() -> icr.DryRun:
    text = (FIG5 / "programs" / "main.task").read_text()
    compiled = ropsim.language.compile(text)
    assert compiled.diagnostics == ()
    assert compiled.icr is not None
    return icr.run(compiled.icr)


@pytest.fixture(scope="module")
def recording() -> Recording:
    return ropsim.open(FIG5).simulate()


def test_it_gives_72_moves_36_closes_and_36_opens_in_turn(trace: icr.DryRun) -> None:
    assert trace.trap is None
    assert len(trace.moves) == 72
    actions = [grip.action for grip in trace.grips]
    assert actions == [GripAction.CLOSE, GripAction.OPEN] * 36
    assert {move.kind for move in trace.moves} == {MotionKind.PTP}


def test_grip_points_step_by_one_millimetre_and_x_is_reset_each_row(trace: icr.DryRun) -> None:
    grips = trace.moves[0::2]
    expected = [[13 + 0.1 * column, 5 + 0.1 * row, 8] for row in range(6) for column in range(6)]
    found = [move.target.position for move in grips if isinstance(move.target, Pose)]
    np.testing.assert_allclose(found, np.array(expected) / 100, atol=ROUNDING)


def test_every_part_is_released_at_the_second_location(trace: icr.DryRun) -> None:
    found = [move.target.position for move in trace.moves[1::2] if isinstance(move.target, Pose)]
    np.testing.assert_allclose(found, np.tile([0.06, 0.03, 0.02], (36, 1)), atol=ROUNDING)


def test_every_instruction_knows_its_line_and_pass(trace: icr.DryRun) -> None:
    lines = {move.origin.span.line for move in trace.moves if move.origin.span}
    assert lines == {3, 9}
    assert [move.origin.visit for move in trace.moves[0::2]] == list(range(1, 37))
    assert trace.moves[0].origin.calls == ("main", "Palletize", "grip")


def test_in_its_cell_all_36_parts_leave_at_location_2(recording: Recording) -> None:
    assert recording.findings == ()
    assert len(recording.facts.parts_left) == 36
    assert sum(event.kind == "move" for event in recording.events) == 72
