"""What is told of names, moves and calls."""

from pathlib import Path

import pytest

from ropsim.workbench import new_project
from support.editors import Editor, place, uri_of

BARE = "file:///nowhere-at-all/x.task"
TEXT = """program p
units mm, deg, s
frame table = (100, 0, 0; rz 90)
loc corner = (10, 20, 300) in table
loc high = corner above 50
loc folded = joints (0, 0, 90, 0, 0, 0)
task Go(part: loc, clear: length = 20 mm, n = 2) -> int
  needs gripper open
  gap = clear + 5 mm
  for k = 1 to n
    lin part above gap
  endf
  return n
endp
m = Go(corner, clear = 30 mm)
repeat 3
  lin (1, 2, 3) in table
endr
"""


def hover(marked: str, uri: str = BARE) -> str:
    answer = Editor().at_mark("hover", uri, marked)
    return str(answer["contents"]["value"]) if answer is not None else ""


def marked(part: str) -> str:
    """Return the text with the mark in the place that a part of it shows."""
    assert TEXT.count(part.replace("|", "")) == 1
    return TEXT.replace(part.replace("|", ""), part)


@pytest.mark.parametrize(
    ("part", "told"),
    [
        ("loc cor|ner", "(80, 10, 300) mm, roll pitch yaw (180, 0, 90)° in the base frame; (10, 20, 300) mm"),
        ("loc hi|gh", "(80, 10, 350) mm, roll pitch yaw (180, 0, 90)° in the base frame"),
        ("  ga|p =", "variable of type length, line 9"),
        ("for |k", "variable of type int, line 10"),
        ("part a|bove", "location above d"),
        ("lin pa|rt", "parameter of type loc, line 7"),
        ("(1, 2|, 3)", "goes at the first of 3 times to (98, 1, 3) mm"),
        ("= G|o(", "task Go(part: loc, clear: length [mm] = 20 mm, n: int = 2) -> int"),
        ("ner, cle|ar", "parameter of type length, line 7"),
    ],
)
def test_a_name_is_told_with_its_type_and_a_place_with_its_numbers(part: str, told: str) -> None:
    assert told in hover(marked(part))


def test_a_location_of_joint_values_has_no_pose_to_tell() -> None:
    assert "mm" not in hover(marked("loc fol|ded"))


def test_a_frame_is_no_location_of_that_name(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text("utf-8") + "\n[signals.pallet]\ninput = 1\n", "utf-8")
    uri = uri_of(folder / "programs" / "x.task")
    assert "frame of the cell" in hover("program x\nunits mm\nmov (1, 2, 3) in pal|let\n", uri)
    assert "signal of the cell" in hover("program x\nunits mm\nwait until pal|let\n", uri)


def test_a_pose_in_the_world_counts_where_the_robot_stands(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "two_arms")
    program = uri_of(folder / "programs" / "right.task")  # its robot stands at x = 1320 mm, turned by 180°
    told = hover("program right\nunits mm, deg\nloc cor|ner = (20, 0, 0; rpy 0 0 0)\nmov corner\n", program)
    assert "(1300, 0, 0) mm, roll pitch yaw (0, 0, 180)° in the world frame" in told


def test_where_a_move_goes_is_told_of_the_last_text_without_errors() -> None:
    editor = Editor()
    editor.open(BARE, TEXT)
    asked = {"textDocument": {"uri": BARE}, "position": place(16, 9)}
    before = editor.ask("textDocument/hover", **asked)["contents"]["value"]
    editor.type(BARE, (17, 0), (17, 0), "lin (1, 2\n")
    assert editor.ask("textDocument/hover", **asked)["contents"]["value"] == before
    editor.type(BARE, (16, 7), (16, 8), "9")
    assert editor.ask("textDocument/hover", **asked) is None


@pytest.mark.parametrize(
    ("call", "active"),
    [
        ("Go |", 0),
        ("Go (1, 2|, 3)", 0),
        ("Go (1, 2, 3), |", 1),
        ("call Go corner, 5, |", 2),
        ("Go(corner, |", 1),
        ("Go(corner above dist(corner, high|), 2", 0),
        ("x = Go((1, 2, 3), n = |", 2),
        ("x = Go((1, 2, 3), n := |", 2),
        ("Go corner, n := 2, clear := |", 1),
        ("if true then Go corner, n = 2, clear = |", 1),
        ("Go corner, 1, 2, 3|", 3),
    ],
)
def test_the_argument_that_is_typed_is_marked(call: str, active: int) -> None:
    answer = Editor().at_mark("signatureHelp", BARE, TEXT + call)
    assert answer["activeParameter"] == active
    (signature,) = answer["signatures"]
    assert signature["label"] == "Go(part: loc, clear: length [mm] = 20 mm, n: int = 2) -> int"
    assert all(one["label"] in signature["label"] for one in signature["parameters"])
    assert signature["documentation"]["value"] == "needs gripper open"


@pytest.mark.parametrize("line", ["lin (1, 2|", "x = sqrt(|", "|Go", 'print "Go(|"', "Stay |"])
def test_outside_of_calls_there_is_no_signature(line: str) -> None:
    assert Editor().at_mark("signatureHelp", BARE, TEXT + line) is None


WAITS = """program main
units mm, s
signal go = input 1
signal ready = input 2
mov (300, 0, 300)
{wait}
mov (310, 20, 330)
"""


@pytest.mark.parametrize(
    "wait",
    [
        "wait until go",
        "wait until go timeout 2",
        "wait until go and ready",
        "wait 1",
        "if go\n  wait 1\nendif",
    ],
)
def test_behind_a_wait_the_place_of_a_move_is_known(wait: str) -> None:
    assert "goes to (310, 20, 330) mm" in hover(WAITS.format(wait=wait).replace("mov (310", "mo|v (310"))


def test_a_line_that_needs_an_input_tells_where_it_goes() -> None:
    text = WAITS.format(wait="if go\n  mov (320, 0, 300)\nendif")
    assert "goes to (320, 0, 300) mm" in hover(text.replace("mov (320", "mo|v (320"))


def test_a_name_of_the_cell_tells_its_pose_in_the_world_and_from_the_base(tmp_path: Path) -> None:
    folder = new_project(tmp_path / "cell", "first_cell")
    cell = folder / "cell.toml"
    based = 'tool = "jaws"\nbase = { position = [100, 0, 0] }\n'
    cell.write_text(cell.read_text("utf-8").replace('tool = "jaws"\n', based, 1), "utf-8")
    told = hover("program x\nunits mm\nmov pick|_up\n", uri_of(folder / "programs" / "main.task"))
    assert "(500, 300, 560) mm" in told
    assert "in the world frame" in told
    assert "(400, 300, 560) mm" in told
    assert "in the base frame" in told


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("l|in (500, 50, 600) free", "(500, 50, 600) mm, roll pitch yaw (180, 0, 0)° in the base frame; its"),
        ("l|in (500, 50, 600; free)", "its orientation is free"),
        ("lin (500, 50, 600) fr|ee", "location free"),
    ],
)
def test_a_free_orientation_is_told(line: str, told: str) -> None:
    assert told in hover(f"program p\nunits mm, deg\nmov (400, 0, 600)\n{line}\n")


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("circ via (500, 5|0, 600) to (450, 0, 610)", "leads through (500, 50, 600) mm"),
        ("circ via (500, 50, 600) to (450, |0, 610)", "goes to (450, 0, 610) mm"),
        ("ci|rc via (500, 50, 600) to (450, 0, 610)", "goes to (450, 0, 610) mm"),
        ("mov via (500, |0, 600), (510, 0, 610) to (520, 0, 620)", "passes (500, 0, 600) mm"),
        ("mov via (500, 0, 600), (510, 0, |610) to (520, 0, 620)", "passes (510, 0, 610) mm"),
        ("m|ov via (500, 0, 600), (510, 0, 610) to (520, 0, 620)", "goes to (520, 0, 620) mm"),
        ("mov via home, (510, |0, 610) to (520, 0, 620)", "passes (510, 0, 610) mm"),
        ("spline via (1|0, 0, 600), (20, 10, 600) to (30, 0, 620)", "leads through (10, 0, 600) mm"),
        ("spline via (10, 0, 600), (20, 1|0, 600) to (30, 0, 620)", "leads through (20, 10, 600) mm"),
        ("if true then lin via (1|0, 0, 600) to (30, 0, 620)", "passes (10, 0, 600) mm"),
        ("lin via (10, 0, 600), \\\n  (20, |0, 600) to (30, 0, 620)", "passes (20, 0, 600) mm"),
    ],
)
def test_each_place_of_a_motion_has_its_own_pose(line: str, told: str) -> None:
    head = "program p\nunits mm, deg\nmov (400, 0, 600)\n"
    assert told in hover(f"{head}{line}\n")
    loop = f"{head}for k = 1 to 3\n  {line}\nendf\n"
    verb, _, rest = told.partition(" to " if " to " in told else " (" if "passes" in told else " through")
    assert f"{verb} at the first of 3 times" in hover(loop)
    assert rest in hover(loop)
