"""What completion offers compiles where it is offered, and the likeliest comes first."""

import re
from pathlib import Path

import pytest

from ropsim import language
from ropsim.lsp.testing import UNITS_OF
from ropsim.workbench import new_project
from support.editors import Editor, place, uri_of
from support.programs.making import program as program_of
from support.programs.text import written

BARE = "file:///nowhere-at-all/x.task"
HEAD = """program t
units mm, deg, s
const gap = 12 mm
loc p = (500, 0, 600)
loc q = joints(0, 0, 0, 0, 0, 0)
frame shelf = (1, 2, 3)
signal lamp = output 3
signal force = analog input 4
pattern slots = grid 2 from p step (1, 2, 3)
const twice = 2
n = 3
print n
var lit = true
var taught = (1, 2, 3)
task Put(at_place: loc, high: length)
  lin at_place above high
endp
"""
BEHIND = ["acc", "at", "blend", "fine", "speed", "tool", "track"]
COORDINATES = ["x", "y", "z", "rx", "ry", "rz"]


def labels(marked: str, uri: str = BARE, head: str = HEAD) -> list[str]:
    items = Editor().at_mark("completion", uri, head + marked)["items"]
    return [item["label"] for item in sorted(items, key=lambda item: item["sortText"])]


@pytest.fixture
def program(tmp_path: Path) -> str:
    folder = tmp_path / "cell"
    new_project(folder, "first_cell")
    cell = folder / "cell.toml"
    frame = "\n[frames.pallet]\nposition = [400, 0, 500]\n"
    more = f"{frame}[signals.part_ok]\ninput = 1\n[signals.glue]\noutput = 1\n"
    cell.write_text(cell.read_text("utf-8") + more, "utf-8")
    return uri_of(folder / "programs" / "x.task")


@pytest.mark.parametrize("verb", ["mov", "lin", "mov to", "lin to", "mov via p to", "circ via (1, 2, 3) to"])
def test_every_target_that_is_offered_compiles(program: str, verb: str) -> None:
    offered = [one for one in labels(f"{verb} |", program) if one not in ("via", "joints(")]
    assert {"p", "pick_up", "here"} <= set(offered)
    for target in offered:
        found = Editor().open(program, f"{HEAD}{verb} {target}\n")
        assert [one["message"] for one in found if one["severity"] == 1] == [], target


def test_a_joint_move_is_offered_joint_targets_and_others_are_not() -> None:
    assert labels("mov |") == ["p", "q", "taught", "here", "home", "joints(", "via"]
    assert labels("lin |") == ["p", "taught", "here", "via"]
    assert labels("Put |") == ["p", "taught", "here"]
    assert labels("if force > 3 then mov |")[0] == "p"


def test_only_outputs_can_be_set(program: str) -> None:
    for line in ("set |", "lin p at 3 mm after start do set |"):
        signals = [one for one in labels(line, program) if one in ("glue", "part_ok", "lamp", "force")]
        assert signals == ["glue", "lamp"]
    assert labels("set lamp |") == ["off", "on"]


@pytest.mark.parametrize(
    ("line", "first"),
    [
        ("lin p speed 100 |", ["mm/s", "deg/s", "m/s"]),
        ("mov p speed 100 |", ["%"]),
        ("set speed 100 |", ["mm/s", "deg/s", "m/s", "cm/s", "rad/s", "%"]),
        ("lin p at 3 |", ["mm", "s", "cm"]),
        ("lin p above 3 |", ["mm", "cm", "m", "inch"]),
        ("wait 3 |", ["s", "ms", "min"]),
        ("lin p acc 3 |", ["mm/s2", "m/s2"]),
        ("const k: length = 3 |", ["mm", "cm"]),
        ("mov joints(10 |", ["deg", "rad"]),
        ("lin p until lamp timeout 3|", []),
        ("x = 3 |", ["deg", "deg/s"]),
    ],
)
def test_units_that_fit_come_first(line: str, first: list[str]) -> None:
    offered = labels(line)
    assert offered[: len(first)] == first
    assert set(offered) >= language.UNIT_WORDS - {"%"} or not first


def test_the_units_of_the_text_come_first_of_those_that_fit() -> None:
    head = HEAD.replace("units mm, deg, s", "units m, rad, s  # mm")
    assert labels("lin p speed 100 |", head=head)[:2] == ["m/s", "rad/s"]
    assert labels("lin p above 3 |", head=head)[:2] == ["m", "mm"]


def test_the_units_of_each_kind_are_those_of_the_language() -> None:
    assert {unit for units in UNITS_OF.values() for unit in units} <= language.UNIT_WORDS


@pytest.mark.parametrize(
    "line", ["lin p |", "lin p speed 100 mm/s |", "lin (1, 2, 3) |", "lin p above gap |"]
)
def test_behind_a_target_no_value_is_offered(line: str) -> None:
    offered = labels(line)
    assert offered[0] == "acc"
    assert set(offered).isdisjoint({"p", "lamp", "gap", "n", "and", "do", "true", "sqrt", "here", "along"})
    assert ("above" in offered) is ("speed" not in line)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("if lamp |", ["and", "is", "mod", "or", "then"]),
        ("while lamp |", ["and", "do", "is", "mod", "or"]),
        ("wait until lamp |", ["and", "is", "mod", "or", "timeout"]),
        ("lin p until lamp |", ["is", "store", "timeout", *BEHIND]),
        ("for i = n |", ["mod", "to"]),
        ("lin via p |", ["to", "above", "external", "free", "in", "offset", "rel"]),
        ("x = (n |", ["above", "in", "mod", "offset", "rel"]),
        ("loc z = p |", ["above", "external", "free", "in", "offset", "rel"]),
        ("repeat n |", []),
        ("for each b |", ["in"]),
        ("set fine |", []),
        ("signal more = |", ["analog", "input", "output"]),
        ("signal more = analog |", ["input", "output"]),
        ("signal more = input |", []),
        ("signal more = input 3 |", []),
        ("task T |", []),
        ("task T(a: length) |", []),
        ("task T(a: length, |", []),
        ("lin p track |", ["force"]),
        ("lin p store |", ["taught"]),
        ("circ |", ["via"]),
        ("circ via p |", ["to", "above", "external", "free", "in", "offset", "rel"]),
        ("lin p at 3 mm |", ["after start", "before end"]),
        ("lin p at 3 mm after |", ["start"]),
        ("lin p at 3 mm before |", ["end"]),
        ("lin p at 3 mm after start |", ["do"]),
        ("lin p until |", ["force", "lamp", "not"]),
        ("lin p until not |", ["lamp"]),
        ("lin p until force |", ["<", ">"]),
        ("lin p until lamp is |", ["on", "off", "true", "false", "not"]),
        ("lin p until lamp is not |", ["on", "off", "true", "false"]),
        ("lin p until lamp is on |", ["store", "timeout", *BEHIND]),
        ("lin p until force > n |", ["mod", "store", "timeout", *BEHIND]),
        ("for i = 1 to n |", ["do", "mod", "step"]),
        ("for i = 1 to n step n |", ["do", "mod"]),
        ("pattern pp = |", ["grid"]),
        ("pattern pp = grid |", ["twice"]),
        ("pattern pp = grid 2 |", ["x", "from"]),
        ("pattern pp = grid 2 x |", ["twice"]),
        ("pattern pp = grid 2 x 2 |", ["x", "from"]),
        ("pattern pp = grid 2 x 2 x 2 |", ["from"]),
        ("pattern pp = grid 2 from |", ["p"]),
        ("pattern pp = grid 2 from p |", ["step", "above", "external", "free", "in", "offset", "rel"]),
        ("pattern pp = grid 2 from p step |", []),
        ("pattern pp = grid 2 from p step (1, 2, 3) |", ["order"]),
        ("pattern pp = grid 2 from p step (1, 2, 3) order |", ["row", "column", "snake"]),
        ("print p.|", COORDINATES),
        ("print taught.|", COORDINATES),
        ("print q.|", []),
        ("print gap.|", []),
        ("print shelf.|", []),
        ("for each b in slots\n  print b.|", ["col", "row", "layer", *COORDINATES]),
        ("var k |", []),
        ("stop |", []),
    ],
)
def test_a_value_is_followed_by_words_that_go_on(line: str, words: list[str]) -> None:
    assert labels(line) == words


def test_a_number_that_counts_is_followed_by_words_first() -> None:
    assert labels("for i = 1 |")[:2] == ["mod", "to"]
    assert "then" in labels("if n > 3 |")[:5]
    assert "p" not in labels("repeat |")
    assert labels("x = dist(p, |")[0] == "p"
    assert labels("lin (1, 2, 3; rz |")[0] == "90 deg"


@pytest.mark.parametrize("line", ["x = |", "print |", "x = n + |", "x = (n, |"])
def test_an_expression_begins_with_a_value(line: str) -> None:
    offered = labels(line)
    assert offered[0] == "force"
    assert {"n", "gap", "not", "true", "sqrt"} <= set(offered)
    assert set(offered).isdisjoint(language.INNER_WORDS - {"not", "true", "false", "here"})


@pytest.mark.parametrize(
    ("begun", "rest"),
    [
        ("circ", "p to (1, 2, 3)"),
        (
            "lin p",
            {"speed": "3 mm/s", "acc": "3 mm/s2", "blend": "3 mm", "fine": "", "store": "h"},
        ),
        ("lin p at 3 mm", "do set lamp on"),
        ("lin p at 3 mm after", "do set lamp on"),
        ("lin p at 3 mm after start", "set lamp on"),
        ("lin p until", {"force": "> 3", "not": "lamp"}),
        ("lin p until force", "3"),
        ("lin p until lamp", {"is": "on", "timeout": "3 s", "store": "h", "speed": "3 mm/s"}),
        ("lin p until lamp is", {"not": "on"}),
        ("lin p until force > n", {"timeout": "3 s", "store": "h", "mod": "2"}),
        ("lin p store", ""),
        ("pattern pp = grid 2", {"x": "3 from p step (1, 2, 3), (3, 2, 1)", "from": "p step (1, 2, 3)"}),
        ("pattern pp = grid", "from p step (1, 2, 3)"),
        ("pattern pp = grid 2 from", "step (1, 2, 3)"),
        ("pattern pp = grid 2 from p step (1, 2, 3)", "snake"),
        ("pattern pp = grid 2 from p step (1, 2, 3) order", ""),
        ("signal more = analog", "7"),
        ("print p.", ""),
        ("for i = 1 to 3", {"step": "2", "do": "", "mod": "2"}),
    ],
)
def test_what_is_offered_goes_on_to_what_compiles(begun: str, rest: str | dict[str, str]) -> None:
    end = "\nendf\n" if begun.startswith("for") else "\n"
    start = begun if begun.endswith(".") else f"{begun} "
    behind = rest if isinstance(rest, dict) else dict.fromkeys(labels(f"{start}|"), rest)
    assert behind
    assert behind.keys() <= set(labels(f"{start}|"))
    for word, more in behind.items():
        found = Editor().open(BARE, f"{HEAD}{start}{word} {more}{end}")
        assert [one["message"] for one in found if one["severity"] == 1] == [], word


def test_a_motion_is_not_offered_the_frame_that_it_cannot_have() -> None:
    for line in ("lin p |", "mov p |", "lin p speed 100 mm/s |", "circ via p to p |", "lin p until lamp |"):
        assert "frame" not in labels(line)
    assert {"frame", "speed"} <= set(labels("with |"))
    assert "until" not in labels("lin via p to p |")
    assert {"until", "timeout"}.isdisjoint(labels("lin p until lamp timeout 3 s |"))


def test_what_is_known_before_the_program_runs_is_made_of_no_variable() -> None:
    assert set(labels("const c = |")).isdisjoint({"n", "lit", "taught", "lamp", "force"})
    assert set(labels("loc z = |")).isdisjoint({"n", "lit", "taught", "lamp", "force"})


@pytest.mark.parametrize(
    "line",
    [
        "wait 1|",
        "wait 1.|",
        "wait 1.5|",
        "wait 2e|",
        "wait 1 s|",
        "wait 1s|",
        "wait 1 m|",
        "wait 1 mi|n",
        "lin p speed 100 mm|",
        "lin p speed 100 mm/|",
        "lin p speed 100 mm/s|",
        "lin p acc 100 mm/s2|",
        "mov p speed 20 %|",
        "mov joints(10 deg|, 20 deg)",
        "if n > 3 s|",
    ],
)
def test_in_a_number_or_its_unit_nothing_is_offered_yet(line: str) -> None:
    answer = Editor().at_mark("completion", BARE, HEAD + line)
    assert answer == {"isIncomplete": True, "items": []}


@pytest.mark.parametrize(
    "line",
    ["mov home|", "mov HOME|", "mov ho|me", "lin taught|", "close|", "set lamp on|", "x = n2 + twice|"],
)
def test_what_stands_there_already_is_no_list(line: str) -> None:
    answer = Editor().at_mark("completion", BARE, HEAD + line)
    assert answer == {"isIncomplete": True, "items": []}


@pytest.mark.parametrize("line", ["lin along |", "mov |", "wait |"])
def test_the_empty_answer_to_a_space_does_not_hold_for_the_word_behind_it(line: str) -> None:
    """It may come when the first letter of the word is typed already: an editor then has to ask again."""
    trigger = {"triggerKind": 2, "triggerCharacter": " "}
    answer = Editor().at_mark("completion", BARE, HEAD + line, context=trigger)
    assert answer == {"isIncomplete": True, "items": []}


@pytest.mark.parametrize(
    ("line", "new"),
    [
        ("mo|", "mov"),
        ("mov|", "movc"),
        ("end|", "endwith"),
        ("mov hom|", "home"),
        ("wait 1 |", "s"),
        ("for i = 1 t|", "to"),
        ("lin p speed 100 mm/s b|", "blend"),
        ("x = 100 mm / t|", "twice"),
    ],
)
def test_what_is_longer_or_other_than_what_stands_there_is_offered(line: str, new: str) -> None:
    assert new in labels(line)


@pytest.mark.slow
def test_no_list_at_any_place_of_a_program_repeats_the_word_before_it() -> None:
    for seed in range(6):
        text = written(program_of(seed))
        editor = Editor()
        editor.open(BARE, text)
        for number, line in enumerate(text.splitlines()):
            for word in re.finditer(r"\w+", line):
                answer = editor.ask(
                    "textDocument/completion",
                    textDocument={"uri": BARE},
                    position=place(number, word.end()),
                )
                offered = [one["label"] for one in answer["items"]]
                assert not offered or set(offered) - {word[0]}, line
