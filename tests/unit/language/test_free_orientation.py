"""Locations whose orientation is free: the word behind them and among their terms."""

import pytest

from ropsim.flow import MoveInstruction, PostureRequest, TargetOrientation
from ropsim.icr import disassemble, run
from ropsim.language import compile as compile_text
from ropsim.language import formatted
from support.tasks import CELL, codes, compiled, only

UNITS = "program p\nunits mm, deg, s\n"
FREE = TargetOrientation.FREE


def moves(text: str) -> list[MoveInstruction]:
    result = compiled(UNITS + text, CELL)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    trace = run(result.icr)
    assert trace.trap is None
    return list(trace.moves)


@pytest.mark.parametrize(
    "text",
    [
        "lin (850, 0, 700) free",
        "lin (850, 0, 700; free)",
        "lin (850, 0, 700; down, free)",
        "LIN (850, 0, 700; FREE)",
        "lin (850, 0, 700; free) free",
        "lin (850, 0, 690) free offset (0, 0, 10)",
        "lin (850, 0, 690) offset (0, 0, 10) free speed 20 mm/s",
        "lin (850, 0, 720) free above 20",
        "lin (850, 0, 700) in base free",
        "lin (850, 0, 700) external (800, 0) free",
        "lin (850, 0, 700) free external (800, 0)",
        "loc q = (850, 0, 700; free)\nlin q",
        "q = (850, 0, 700)\nlin q free",
        "q = (850, 0, 700) free\nr = q\nlin r",
        "task T(at_: loc)\nlin at_\nendp\nT (850, 0, 700; free)",
        "task T(at_: loc)\nlin at_\nendp\nT (850, 0, 700) free",
        "task T(at_: loc)\nlin at_ free\nendp\nT (850, 0, 700)",
        "pattern slots = grid 2 from (850, 0, 700) free step (0, 0, 9)\nfor each s in slots\nlin s\nendf",
    ],
)
def test_a_location_is_free_wherever_it_goes(text: str) -> None:
    (move, *_) = moves(text)
    assert move.has_free_orientation
    assert isinstance(move.posture, PostureRequest)


def test_what_else_it_asks_of_the_arm_stays() -> None:
    (one, other) = moves("lin (850, 0, 700; config (left), free)\nlin (850, 0, 700; config (left)) free")
    assert one.posture == other.posture == PostureRequest(("left",), (), FREE)


def test_the_frame_of_a_variable_stays() -> None:
    """A location in a frame of its own goes on in it."""
    text = "q = (10, 20, 60) in pallet\nlin q free\nlin q"
    free, plain = moves(text)
    assert free.target == plain.target
    assert (free.has_free_orientation, plain.has_free_orientation) == (True, False)


def test_the_word_may_be_a_name() -> None:
    (move,) = moves("var free: length = 20\nlin (850, 0, 700) free above free")
    assert move.has_free_orientation
    assert codes(UNITS + "task free(n: int)\nprint n\nendp\nfree 3") == []


@pytest.mark.parametrize(
    ("line", "code", "words"),
    [
        ("lin joints(0, 0) free", "T301", "joint coordinates leave nothing free"),
        ("x = 3 free", "T301", "right behind the location"),
        ("lin infeed rel ((0, 0, 5) free)", "T301", "behind the whole"),
        ("lin infeed rel (0, 0, 5; free)", "T301", "leave them out here"),
        ("frame shelf = (0, 0, 300; free)", "T301", "leave them out here"),
        ("lin infeed speed 20 free", "T301", "before `speed`"),
        ("lin (1, 2, 3; free, free)", "L101", "stands once"),
        ("circ via (1, 2, 3) free to (3, 4, 5)", "T301", "give them to the target"),
    ],
)
def test_elsewhere_it_is_refused_with_its_place(line: str, code: str, words: str) -> None:
    found = only(UNITS + line)
    assert found.code == code
    assert words in found.hint


def test_behind_a_modifier_without_a_value_it_is_moved_by_its_fix() -> None:
    found = only(UNITS + "lin infeed fine free")
    assert found.fix is not None
    assert found.fix.replacement == "free fine"


def test_the_form_of_a_text_keeps_it() -> None:
    assert formatted("LIN (850,0,700)   FREE blend 5") == "lin (850, 0, 700) free blend 5\n"
    assert formatted("lin (850,0,700;FREE)") == "lin (850, 0, 700; free)\n"


def test_neutral_code_marks_the_pose() -> None:
    made = compile_text(UNITS + "lin (850, 0, 700) free\nq = (1, 2, 3)\nlin q free")
    assert made.icr is not None
    text = disassemble(made.icr)
    assert "ORI.FREE\n  MOVE.LIN" in text
    assert "LOAD q\n  ORI.FREE\n  MOVE.LIN" in text
    assert "REQUIRE CAP FREE LIN" in text
