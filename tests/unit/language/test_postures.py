"""Locations that say in which posture the arm reaches them, and in which turns its axes are there."""

from dataclasses import replace

import pytest

from ropsim.flow import MoveInstruction, PostureRequest
from ropsim.icr import run
from ropsim.kinematics import solver_of
from ropsim.language import Environment
from ropsim.robots import default_controller, load, names
from ropsim.workbench import environment_of
from support.cells import one_station
from support.tasks import CELL, codes, compiled, only

WORDS = (("left", "right"), ("up", "down"), ("noflip", "flip"))
ARM = replace(CELL, postures=WORDS, axes=("angle",) * 6, external=())
UNITS = "program p\nunits mm, deg, s\n"
WANTED = PostureRequest(("right", "up"), (0, -1, 0))
ASKED = "config (right, up), turns (0, -1, 0)"


def moves(text: str, environment: Environment = ARM) -> list[MoveInstruction]:
    result = compiled(UNITS + text, environment)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    trace = run(result.icr)
    assert trace.trap is None
    return list(trace.moves)


@pytest.mark.parametrize(
    "text",
    [
        f"mov (300, -250, 40; {ASKED})",
        f"mov (300, -250, 40; rz 30, {ASKED}, rx 180)",
        f"mov (300, -250, 40, 90, 0; {ASKED})",
        f"mov (300, -250, 40, 180, 0, 0; {ASKED})",
        "mov (300, -250, 40; TURNS (0, 1 - 2, 0), CONFIG (right, up))",
        "const k = 1\nmov (300, -250, 40; config (right, up), turns (0, -k, 0))",
        f"loc q = (300, -250, 40; {ASKED})\nmov q",
        f"loc q = (300, -250, 40; {ASKED}) above 5\nlin q rel (0, 0, 9; rz 20)",
        f"q = (300, -250, 40; {ASKED})\nq.y = q.y + 5\nmov q offset (1, 2, 3)",
        f"mov (300, -250, 40; {ASKED}) in pallet",
        f"with frame pallet\nmov (300, -250, 40; {ASKED})\nendwith",
        f"x = 300\nmov (x, -250, 40; {ASKED})",
        f"task Go(q: loc)\nmov q above 5\nendp\nGo (300, -250, 40; {ASKED})",
        f"task Go(q: loc = (300, -250, 40; {ASKED}))\nmov q\nendp\nGo",
        f"task Spot -> loc\nreturn (300, -250, 40; {ASKED})\nendp\nq = Spot()\nmov q",
        f"pattern row = grid 1 from (300, -250, 40; {ASKED}) step (9, 0, 0)\nfor each q in row\nmov q\nendf",
        f"circ via (0, 0, 40) to (300, -250, 40; {ASKED})",
        f"circ via (0, 0, 40; {ASKED}) to (300, -250, 40; {ASKED})",
    ],
)
def test_a_posture_goes_wherever_the_location_goes(text: str) -> None:
    assert [one.posture for one in moves(text)] == [WANTED]


def test_external_values_and_a_posture_stand_beside_each_other() -> None:
    track = replace(ARM, axes=(*ARM.axes, "length"), external=("length",))
    for written in (
        f"(1, 2, 3; {ASKED}) external (800)",
        f"(1, 2, 3; {ASKED}) above 5 external (800) in pallet",
    ):
        (move,) = moves(f"mov {written}", track)
        assert (move.posture, move.external) == (WANTED, (0.8,))


def test_a_location_in_a_frame_that_moves_keeps_its_posture() -> None:
    moving = replace(ARM, frames={**CELL.frames, "plate": CELL.frames["pallet"]}, moving=frozenset(["plate"]))
    (move,) = moves(f"loc q = (1, 2, 3; {ASKED}) in plate\nmov q above 5", moving)
    assert (move.posture, move.modal.frame) == (WANTED, "plate")


def test_what_asks_nothing_leaves_the_posture_to_the_planner() -> None:
    assert [one.posture for one in moves("mov infeed\nmov (1, 2, 3)\nmov home\nlin infeed above 3")] == [
        None
    ] * 4


def test_an_orientation_alone_is_taken_by_like() -> None:
    assert moves(f"mov (1, 2, 3; like (3, 4, 5; {ASKED}))")[0].posture is None


@pytest.mark.parametrize("words", ["righty", "lft, up", "up, nofilp"])
def test_a_word_that_is_no_posture_of_the_arm_is_told_with_the_nearest(words: str) -> None:
    found = only(UNITS + f"mov (1, 2, 3; config ({words}))", ARM)
    assert found.code == "N216"
    assert found.fix is not None
    assert found.fix.replacement in {"right", "left", "noflip"}


def test_two_words_of_one_part_exclude_each_other() -> None:
    assert codes(UNITS + "mov (1, 2, 3; config (left, right))", ARM) == ["T301"]
    assert codes(UNITS + "mov (1, 2, 3; config (up, left, up))", ARM) == ["T301"]
    assert codes(UNITS + "mov (1, 2, 3; config (flip, up, left))", ARM) == []


def test_an_arm_whose_postures_have_no_names_takes_none() -> None:
    nameless = replace(ARM, postures=())
    assert codes(UNITS + "mov (1, 2, 3; config (up))", nameless) == ["T301"]
    assert codes(UNITS + "mov (1, 2, 3; turns (1))", nameless) == []


def test_turns_are_whole_numbers_one_for_each_axis_that_turns() -> None:
    scara = replace(ARM, axes=("angle", "angle", "length", "angle"))
    assert codes(UNITS + "mov (1, 2, 3; turns (1, 2, 0, -1))", scara) == []
    assert codes(UNITS + "mov (1, 2, 3; turns (1, 2, 1))", scara) == ["T306"]
    assert codes(UNITS + "mov (1, 2, 3; turns (0, 0, 0, 0, 0))", scara) == ["T306"]
    assert codes(UNITS + "mov (1, 2, 3; turns (0.5))", scara) == ["T304"]
    assert codes(UNITS + "n = 1\nmov (1, 2, 3; turns (n))", scara) == ["T305"]


@pytest.mark.parametrize("name", names())
def test_the_words_of_a_robot_are_those_of_its_postures(name: str) -> None:
    robot = load(name)
    parts = environment_of(one_station("c", robot, default_controller(name))).postures
    assert parts is not None
    for posture in solver_of(robot).postures if robot.has_arm else ():
        assert len(posture.words) == len(parts)
        assert all(word in part for word, part in zip(posture.words, parts, strict=True))
    flat = [word for part in parts for word in part]
    assert len(flat) == len(set(flat))


@pytest.mark.parametrize("word", ["config (left, up)", "turns (0, -1)"])
@pytest.mark.parametrize("before", ["", " above 150", " above 150 mm", " blend 3 mm"])
def test_a_posture_behind_a_location_is_told_where_it_belongs(before: str, word: str) -> None:
    found = only(UNITS + f"mov (300, -250, 40){before} {word}", ARM)
    assert found.code == "L101"
    name = word.split(maxsplit=1)[0]
    assert found.message == f"`{name}` stands in a location, behind its `;`"
    assert found.hint == f"write `(x, y, z; {word})`"
    assert codes(UNITS + f"mov {found.hint.split('`')[1]}".replace("x, y, z", "300, -250, 40"), ARM) == []


def test_where_no_arm_is_known_words_in_capitals_are_no_postures() -> None:
    """ICR has them in small letters: compiled, they would be refused by its verifier."""
    found = only(UNITS + "mov (1, 2, 3; config (left, UP))", replace(ARM, postures=None))
    assert found.code == "N216"
    assert found.fix is not None
    assert found.fix.replacement == "up"
    assert codes(UNITS + "mov (1, 2, 3; config (left, up))", replace(ARM, postures=None)) == []
