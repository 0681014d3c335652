"""Motions whose path a sensor corrects: what the clause says, and what it may not."""

from dataclasses import replace

import pytest

from ropsim.flow import MoveInstruction, PathTracking, SyncInstruction, ToolDirection
from ropsim.icr import Finished, Machine, StillWorld, disassemble, read_text, run
from ropsim.program import SignalUse, ValueType
from support.tasks import CELL, codes, compiled

SIGNALS = replace(
    CELL,
    signals={
        **CELL.signals,
        "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL),
        "height": SignalUse("height", is_input=True, type=ValueType.REAL),
        "force_z": SignalUse("force_z", is_input=True, type=ValueType.REAL),
    },
)
UNITS = "program p\nunits mm, deg, s\n"
PATHS = [
    "lin infeed",
    "circ via infeed above 9 to infeed above 20",
    "spline infeed above 9 to infeed above 20",
]


def moves(text: str) -> list[MoveInstruction]:
    result = compiled(UNITS + text, SIGNALS)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    trace = run(result.icr, StillWorld({}))
    assert trace.trap is None
    return list(trace.moves)


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize(
    ("clause", "tracking"),
    [
        ("track height = 12 mm", PathTracking("height", 0.012)),
        ("track height := 12 mm", PathTracking("height", 0.012)),
        ("track height = 0.012 along z gain 10", PathTracking("height", 0.012)),
        ("TRACK height = 12 mm ALONG -X", PathTracking("height", 0.012, ToolDirection.MINUS_X)),
        ("track height = h / 2 gain n along y", PathTracking("height", 0.004, ToolDirection.Y, 3.0)),
        (
            "track force_z = 15 N along -z gain 0.0001",
            PathTracking("force_z", 15.0, ToolDirection.MINUS_Z, 1e-4),
        ),
    ],
)
def test_a_path_is_corrected_by_a_signal_and_its_value(
    path: str, clause: str, tracking: PathTracking
) -> None:
    one, two = moves(
        f"n = 3\nh = 8 mm\n{path} speed 50 mm/s {clause} at 3 after start do set glue on\nlin infeed"
    )
    assert one.tracking == tracking
    assert len(one.triggers) == 1
    assert two.tracking is None  # it holds for one motion


def test_a_condition_may_end_a_path_that_is_corrected() -> None:
    (move,) = moves("lin infeed until part_ok timeout 2 track height = 12 mm")
    assert move.guard is not None
    assert move.tracking is not None


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("mov infeed track height = 12 mm", "T301"),
        ("lin via infeed above 9 to infeed track height = 12 mm", "T301"),
        ("lin infeed track part_ok = 1", "T301"),
        ("lin infeed track infeed = 1", "T301"),
        ("lin infeed track height2 = 1", "N202"),
        ("lin infeed track height = part_ok", "T301"),
        ("lin infeed track height = infeed", "T301"),
        ("lin infeed track height = 12 mm gain 0", "T306"),
        ("lin infeed track height = 12 mm gain -3", "T306"),
        ("lin infeed track height = 12 mm gain 5 mm", "T302"),
        ("lin infeed track height = 12 mm along w", "L101"),
        ("lin infeed track height = 12 mm along", "L101"),
        ("lin infeed track height 12 mm", "L101"),
        ("lin infeed track 12 = height", "L101"),
        ("lin infeed track height = 1 track force_z = 2", "L101"),
        ("lin infeed track height = 1 along x along y", "L101"),
        ("lin infeed track height = 1 gain 1 gain 2", "L101"),
        ("lin infeed along x", "L101"),
    ],
)
def test_a_clause_that_makes_no_sense_is_told(line: str, code: str) -> None:
    assert codes(UNITS + line, SIGNALS) == [code]


def test_the_words_of_the_clause_may_be_names() -> None:
    assert moves("gain = 3\nalong = 4\ntrack = 5\nlin infeed track height = 12 mm gain gain")[0].tracking == (
        PathTracking("height", 0.012, gain=3.0)
    )


def test_behind_a_path_that_is_corrected_the_program_waits_for_the_pose() -> None:
    result = compiled(UNITS + "lin infeed track height = 12 mm\nlin here above 5", SIGNALS)
    assert result.icr is not None
    machine = Machine(result.icr, world := StillWorld())
    handed = []
    while not isinstance(step := machine.advance(), Finished):
        world.carry_out(step)
        handed.append(step.before if isinstance(step, SyncInstruction) else type(step).__name__)
    assert handed == ["MoveInstruction", "CURPOSE", "MoveInstruction", "HALT"]


def test_a_gain_that_is_computed_and_is_not_positive_is_a_trap() -> None:
    result = compiled(UNITS + "n = 0\nrepeat 1\nn = n - 1\nendr\nlin infeed track height = 1 gain n", SIGNALS)
    assert result.icr is not None
    trace = run(result.icr, StillWorld({}))
    assert trace.trap is not None


def test_the_neutral_program_carries_the_clause_through_its_text() -> None:
    result = compiled(UNITS + "lin infeed track height = 12 mm along -y", SIGNALS)
    assert result.icr is not None
    text = disassemble(result.icr)
    assert "  TRACK -y height" in text
    assert "TRACK" in text.split("REQUIRE CAP", 1)[1].split("\n", 1)[0]
    again, findings = read_text(text)
    assert findings == ()
    assert again is not None
    assert disassemble(again) == text


@pytest.mark.parametrize(("value", "told"), [("12", ["T313"]), ("12 N", ["T313"]), ("12 mm", []), ("0", [])])
def test_a_value_that_is_not_of_what_the_sensor_measures_is_told(value: str, told: list[str]) -> None:
    measuring = replace(SIGNALS, measured={"height": "length"})
    assert codes(f"{UNITS}lin infeed track height = {value}\n", measuring) == told
