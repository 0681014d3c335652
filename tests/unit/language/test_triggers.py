"""Outputs that are set on the way of a motion: how they are written, and on which move they end up."""

from dataclasses import replace

import pytest

from ropsim.flow import MoveInstruction, Side, Trigger
from ropsim.icr import run
from ropsim.program import SignalUse, ValueType
from support.tasks import CELL, codes, compiled

OUTPUTS = replace(
    CELL,
    signals={
        **CELL.signals,
        "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL),
        "rate": SignalUse("rate", is_input=False, type=ValueType.REAL),
    },
)
UNITS = "program p\nunits mm, deg, s\n"


def moves(text: str) -> list[MoveInstruction]:
    result = compiled(UNITS + text, OUTPUTS)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    return list(run(result.icr).moves)


@pytest.mark.parametrize(
    ("written", "trigger"),
    [
        ("at 3 mm after start do set glue on", Trigger("glue", True, Side.AFTER_START, distance=0.003)),
        ("at 3 after start do set glue on", Trigger("glue", True, Side.AFTER_START, distance=0.003)),
        ("AT 0.5 cm BEFORE END DO SET glue OFF", Trigger("glue", False, Side.BEFORE_END, distance=0.005)),
        ("at 0.2 s before end do set glue off", Trigger("glue", False, Side.BEFORE_END, time=0.2)),
        ("at 0 after start do set rate = 2.5", Trigger("rate", 2.5, Side.AFTER_START, distance=0.0)),
        ("at d * 2 after start do set glue = d > 1", Trigger("glue", True, Side.AFTER_START, distance=0.008)),
        ("at t before end do set glue = not part_ok", Trigger("glue", True, Side.BEFORE_END, time=0.5)),
    ],
)
def test_a_trigger_has_a_place_an_end_and_an_output(written: str, trigger: Trigger) -> None:
    for verb in ("mov", "lin", "circ via infeed above 30 to"):
        (move,) = moves(f"d = 4 mm\nt = 0.5 s\n{verb} infeed offset (9, 0, 0) {written} blend 3")
        assert move.triggers == (trigger,)
        assert move.modal.zone == 0.003


def test_triggers_keep_the_order_in_which_they_are_written() -> None:
    sets = " ".join(f"at {k} before end do set rate = {k}" for k in (3, 1, 2))
    (move,) = moves(f"lin infeed {sets}")
    assert [one.value for one in move.triggers] == [3.0, 1.0, 2.0]


def test_on_a_way_through_points_they_count_from_its_two_ends() -> None:
    ends = "at 1 before end do set rate = 1 at 2 after start do set rate = 2 at 3 before end do set rate = 3"
    found = moves(f"lin via infeed, infeed above 10 to infeed above 20 {ends}")
    assert [[one.value for one in move.triggers] for move in found] == [[2.0], [], [1.0, 3.0]]


def test_what_is_set_is_computed_before_the_motion_begins() -> None:
    (move,) = moves("n = 1\nlin infeed at 1 before end do set rate = n\nn = 2")
    assert move.triggers[0].value == 1.0


def test_a_classic_task_reads_the_names_of_its_triggers() -> None:
    text = "signal glue = output 1\ntask Bead\nlin l at a after start do set glue = b > 1\nendp\n"
    result = compiled(text + "call Bead (1, 2, 3), 0.5, 2")
    assert result.program is not None
    assert [one.name for one in result.program.tasks[0].parameters] == ["l", "a", "b"]


def test_start_end_after_and_before_may_be_names() -> None:
    (move,) = moves("start = 3 mm\nafter = true\nlin infeed at start after start do set glue = after")
    assert move.triggers == (Trigger("glue", True, Side.AFTER_START, distance=0.003),)


def test_a_place_of_another_dimension_is_refused() -> None:
    assert codes(UNITS + "lin infeed at 3 deg after start do set glue on", OUTPUTS) == ["T302"]
    assert codes(UNITS + "lin infeed at 50 % after start do set glue on", OUTPUTS) == ["T302"]
