"""Motions that end by a condition: what conditions say, and where the pose of the arm is kept."""

from dataclasses import replace

import pytest

from ropsim.flow import Comparison, Guard, MoveInstruction
from ropsim.icr import StillWorld, disassemble, run
from ropsim.program import SignalUse, ValueType
from ropsim.spatial import Pose
from support.tasks import CELL, codes, compiled, only

SIGNALS = replace(
    CELL,
    signals={
        **CELL.signals,
        "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL),
        "force_z": SignalUse("force_z", is_input=True, type=ValueType.REAL),
    },
)
UNITS = "program p\nunits mm, deg, s\n"
IS, ABOVE, BELOW = Comparison.IS, Comparison.ABOVE, Comparison.BELOW


def moves(text: str, **inputs: bool | float) -> list[MoveInstruction]:
    result = compiled(UNITS + text, SIGNALS)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    trace = run(result.icr, StillWorld(inputs))
    assert trace.trap is None
    return list(trace.moves)


@pytest.mark.parametrize(
    ("condition", "guard"),
    [
        ("part_ok", Guard("part_ok", IS, value=True)),
        ("not part_ok", Guard("part_ok", IS, value=False)),
        ("part_ok is on", Guard("part_ok", IS, value=True)),
        ("PART_OK IS NOT TRUE".replace("PART_OK", "part_ok"), Guard("part_ok", IS, value=False)),
        ("not (part_ok is off)", Guard("part_ok", IS, value=True)),
        ("part_ok = false", Guard("part_ok", IS, value=False)),
        ("true <> part_ok", Guard("part_ok", IS, value=False)),
        ("glue = part_ok", Guard("glue", IS, value=True)),
        ("part_ok = (n > 2)", Guard("part_ok", IS, value=True)),
        ("force_z > 15 N", Guard("force_z", ABOVE, 15.0)),
        ("force_z > 15", Guard("force_z", ABOVE, 15.0)),
        ("force_z < f / 2", Guard("force_z", BELOW, 4.0)),
        ("2 * n < force_z", Guard("force_z", ABOVE, 6.0)),
        ("20 mm > force_z", Guard("force_z", BELOW, 0.02)),
        ("force_z > n", Guard("force_z", ABOVE, 3.0)),
    ],
)
@pytest.mark.parametrize("verb", ["mov", "lin", "circ via infeed above 9 to", "spline infeed above 9 to"])
def test_a_condition_compares_one_signal(condition: str, guard: Guard, verb: str) -> None:
    text = f"n = 3\nf = 8 N\n{verb} infeed offset (5, 0, 0) until {condition} timeout 2"
    (move,) = moves(text, part_ok=True)
    assert move.guard == replace(guard, timeout=2.0)
    (move,) = moves(text.removesuffix(" timeout 2"), part_ok=True)
    assert move.guard == guard


def test_the_value_is_that_when_the_motion_begins() -> None:
    first, second = moves("x = 1\nlin infeed until force_z > x\nx = 2\nlin infeed until force_z > x")
    assert (first.guard, second.guard) == (Guard("force_z", ABOVE, 1.0), Guard("force_z", ABOVE, 2.0))


def test_a_timeout_that_is_computed_is_at_least_a_tick() -> None:
    (move,) = moves("t = 2 s\nlin infeed until part_ok timeout t - 3 s")
    assert move.guard is not None
    assert move.guard.timeout == pytest.approx(0.004)


def test_the_pose_of_the_arm_is_kept_in_a_variable() -> None:
    text = "lin infeed until part_ok store touch\nlin touch rel (0, 0, -5)\nprint dist(touch, infeed)"
    _, back = moves(text)
    assert isinstance(back.target, Pose)
    assert back.target.as_tuple()[2] == pytest.approx(0.105)


def test_a_pose_is_kept_for_the_tool_of_the_motion_and_without_a_condition() -> None:
    result = compiled(UNITS + "tool probe = (0, 0, 90)\nlin infeed store touch tool probe", SIGNALS)
    assert result.icr is not None
    text = disassemble(result.icr)
    assert text.index("TOOL probe\n") < text.index("ATTAINED\n  STORE touch\n  MODAL.RESTORE")


def test_after_a_guarded_motion_here_is_read_when_it_has_ended() -> None:
    _, up = moves("lin infeed until part_ok\nlin here above 5")
    assert isinstance(up.target, Pose)
    assert up.target.as_tuple()[2] == pytest.approx(0.105)


def test_an_arc_after_a_guarded_motion_begins_somewhere() -> None:
    arc = "circ via infeed offset (10, 0, 0) to infeed offset (20, 0, 0)"
    assert codes(UNITS + f"lin infeed\n{arc}", SIGNALS) == ["T393"]
    assert codes(UNITS + f"lin infeed until part_ok\n{arc}", SIGNALS) == []


def test_a_variable_that_is_stored_is_a_location_from_then_on() -> None:
    found = only(UNITS + "lin infeed until part_ok store touch\nwait touch", SIGNALS)
    assert found.code == "T301"
    assert codes(UNITS + "strict\nlin infeed until part_ok store touch", SIGNALS) == ["T311"]
    assert codes(UNITS + "strict\nvar touch: loc\nlin infeed until part_ok store touch", SIGNALS) == []


def test_a_wrong_motion_leaves_its_variable_unreported() -> None:
    assert codes(UNITS + "lin infeed until parts_ok store touch\nlin touch", SIGNALS) == ["N202"]


def test_a_classic_task_reads_its_condition_and_writes_what_it_stores() -> None:
    text = (
        "signal force_z = analog input 1\ntask Feel\nlin l until force_z > a timeout t store q\nlin q\nendp\n"
    )
    result = compiled(text + "call Feel (1, 2, 3), 0.5, 2")
    assert result.program is not None
    assert [one.name for one in result.program.tasks[0].parameters] == ["l", "a", "t"]


@pytest.mark.parametrize("condition", ["force_z > 15 N", "15 N < force_z", "force_z >= 15 N"])
def test_an_analog_signal_is_compared_with_quantities_elsewhere_too(condition: str) -> None:
    assert len(moves(f"if {condition} then lin infeed", force_z=15.5)) == 1
    assert moves(f"if {condition} then lin infeed", force_z=14.5) == []


SENSED = replace(
    SIGNALS,
    signals={**SIGNALS.signals, "gap": SignalUse("gap", is_input=True, type=ValueType.REAL)},
    measured={"gap": "length", "force_z": "force"},
)


@pytest.mark.parametrize("text", ["lin infeed until {}", "wait until {}", "if {} then\n  stop\nendif"])
@pytest.mark.parametrize(
    ("condition", "hint"),
    [("gap < 12", "write `12 mm`, or `12 m`"), ("2.5 > gap", "write `2.5 mm`, or `2.5 m`")],
)
def test_a_bare_number_beside_a_length_that_is_measured_is_told(text: str, condition: str, hint: str) -> None:
    found = only(UNITS + text.format(condition) + "\n", SENSED)
    number = hint.split()[1].strip("`")
    assert (found.code, found.hint) == ("T313", hint)
    assert found.message == f"`gap` measures a length, and {number} without a unit counts as {number} m here"
    assert found.span is not None
    line = compiled(UNITS + text.format(condition), SENSED).source.line(3)
    assert line[found.span.column - 1 : found.span.end_column - 1] == number


@pytest.mark.parametrize(
    "condition", ["gap < 12 mm", "gap > 0", "force_z > 15", "force_z > 15 N", "gap < x / 2", "gap < gap"]
)
def test_units_nothing_and_what_was_worked_out_are_no_mistakes(condition: str) -> None:
    assert codes(f"{UNITS}x = gap\nprint x\nwait until {condition}\n", SENSED) == []


def test_in_metres_a_bare_number_is_what_it_seems() -> None:
    assert codes("program p\nunits m, deg, s\nwait until gap < 12\n", SENSED) == []


def test_a_reading_is_compared_with_what_it_measures() -> None:
    found = only(f"{UNITS}lin infeed until gap > 15 N\n", SENSED)
    assert (found.code, found.message) == (
        "T313",
        "`gap` measures a length, it is compared with a force",
    )
