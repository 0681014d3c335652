"""What the results of lines hang on: keys change where something before or in the stretch of a line does."""

import sys
from dataclasses import replace

import pytest

from ropsim.icr import StillWorld, line_contents, line_contents_of_all
from ropsim.language import compile

TEXT = """program main
units mm, s
mov (400, 0, 300)
lin (400, 0, 200)
lin (400, 100, 200)
wait 0.5
mov (300, 0, 300)
lin (300, 0, 200)
"""
LOOKS = """program main
units mm, s
signal part = input 1
mov (400, 0, 300)
if part
  mov (300, 0, 300)
endif
mov (300, 100, 300)
"""


def keys(text: str, *around: str) -> dict[int, str]:
    code = compile(text).icr
    assert code is not None
    return dict(line_contents(code, *around))


def unchanged(before: str, after: str) -> list[int]:
    """Return the lines of a text of as many lines whose results must be the same."""
    known, found = keys(before), keys(after)
    return sorted(line for line, key in known.items() if found.get(line) == key)


@pytest.mark.parametrize(
    ("old", "new", "same"),
    [
        ("mov (400", "mov (410", []),
        ("lin (400, 100", "lin (400, 110", []),  # the `mov` above looks ahead for its posture
        ("wait 0.5", "wait 0.6", [3, 4, 5]),
        ("lin (300", "lin (310", [3, 4, 5, 6]),
        ("wait 0.5", "wait 0.5  # a remark", [3, 4, 5, 6, 7, 8]),
        ("program main", "program another", [3, 4, 5, 6, 7, 8]),
    ],
)
def test_an_edit_leaves_what_is_done_before_its_stretch(old: str, new: str, same: list[int]) -> None:
    assert unchanged(TEXT, TEXT.replace(old, new, 1)) == same


def test_keys_follow_lines_that_move_in_the_text() -> None:
    moved = keys(TEXT.replace("mov", "# one\n\nmov", 1))
    assert moved == {line + 2: key for line, key in keys(TEXT).items()}


def test_corners_hang_on_the_moves_that_are_known_with_them() -> None:
    text = TEXT.replace("lin (300", "lin (300, 50, 250) blend 20\nlin (300").replace("mov (300", "lin (300")
    assert unchanged(text, text.replace("lin (300, 0, 200)", "lin (300, 9, 200)")) == [3, 4, 5, 6, 7]


def test_behind_a_look_everything_hangs_on_the_whole_program() -> None:
    assert unchanged(LOOKS, LOOKS.replace("mov (300, 100", "mov (300, 101")) == [4]
    assert unchanged(LOOKS, LOOKS.replace("  mov (300, 0", "  mov (300, 1")) == [4]
    assert unchanged(LOOKS, LOOKS.replace("endif", "endif  # both")) == [4, 6, 8]


def test_what_comes_again_behind_a_look_hangs_on_the_whole_program() -> None:
    looped = LOOKS.replace("mov (400", "repeat\nmov (400") + "endr\n"
    assert unchanged(looped, looped.replace("mov (300, 100", "mov (300, 101")) == []


def test_what_is_waited_for_is_no_look() -> None:
    text = TEXT.replace("wait 0.5", "wait until go").replace("mov", "signal go = input 1\nmov", 1)
    assert unchanged(text, text.replace("lin (300", "lin (310")) == [4, 5, 6, 7]


@pytest.mark.parametrize("late", ["print 1", "lin (300, 0, 250)", "stop"])
def test_what_is_waited_for_no_longer_than_a_time_is_a_look(late: str) -> None:
    """What comes behind is another one where the time was up."""
    text = TEXT.replace("wait 0.5", f"wait until go timeout 1 s else {late}")
    text = text.replace("mov", "signal go = input 1\nmov", 1)
    assert unchanged(text, text.replace("lin (300, 0, 200)", "lin (310, 0, 200)")) == [4, 5, 6]
    assert unchanged(text, text.replace("timeout 1", "timeout 2")) == [4, 5, 6]


def test_a_program_without_an_end_has_keys_too() -> None:
    endless = TEXT.replace("mov (300", "repeat\nmov (300") + "endr\n"
    assert unchanged(endless, endless.replace("lin (300", "lin (310")) == [3, 4, 5, 6]


def test_cells_and_programs_of_other_stations_count() -> None:
    assert not set(keys(TEXT, "a cell").values()) & set(keys(TEXT, "another").values())
    one, two, three = (compile(TEXT.replace("0.5", pause)).icr for pause in ("0.5", "0.6", "0.7"))
    assert one is not None
    assert two is not None
    assert three is not None
    first, other = (line_contents_of_all({"left": one, "right": beside}, "") for beside in (two, three))
    assert not set(first["left"].values()) & set(other["left"].values())


READS = """program main
units mm, s
signal go = input 1
mov (400, 0, 300)
wait until go
lin (400, 0, 200)
mov (300, 0, 300)
"""


@pytest.mark.parametrize(
    ("text", "same"), [(READS, [4]), (READS.replace("wait until go", "lin (400, 0, 250) until go"), [])]
)
def test_from_the_first_instruction_on_that_reads_a_channel_what_it_says_counts(
    text: str, same: list[int]
) -> None:
    code = compile(text).icr
    assert code is not None
    known, found = (line_contents(code, channels=one) for one in ("on after 1.5 s", "on after 9.5 s"))
    assert sorted(line for line, key in known.items() if found[line] == key) == same


@pytest.mark.parametrize(("word", "same"), [("blend 20", [3, 4]), ("fine", [3, 4, 5])])
def test_a_stretch_that_is_not_known_to_its_end_hangs_on_the_whole_program(
    monkeypatch: pytest.MonkeyPatch, word: str, same: list[int]
) -> None:
    monkeypatch.setattr(sys.modules["ropsim.icr.line_contents"], "MOST", 4)
    line = f"lin (400, 0, 200) {word}\n"
    known = f"program main\nunits mm, s\nmov (400, 0, 300)\nwait 1\n{line * 5}"
    assert unchanged(known, known + line) == same


def test_another_version_has_other_results(monkeypatch: pytest.MonkeyPatch) -> None:
    before = keys(TEXT)
    monkeypatch.setattr(sys.modules["ropsim.icr.line_contents"], "__version__", "0.0.0")
    assert not set(before.values()) & set(keys(TEXT).values())


@pytest.mark.parametrize(("last", "acting"), [("wait 0.5", ["a39 1", "b0 2"]), ("print n", [])])
def test_of_tasks_without_lines_those_act_whose_calls_end_in_an_act(last: str, acting: list[str]) -> None:
    """Each task calls two of the level below, so there are more ways to the last one than can be walked."""
    lines = ["program main", "units mm, s"]
    for name in "ab":
        lines += [f"task {name}0(n: num)", f"  {last}", "endp"]
    for level in range(1, 40):
        for name in "ab":
            lines += [f"task {name}{level}(n: num)", f"  a{level - 1} n", f"  b{level - 1} n", "endp"]
    text = "\n".join((*lines, "a39 1", "b0 2", ""))
    code = compile(text).icr
    assert code is not None
    without = tuple(
        one if one.name == "main" else replace(one, lines=(0,) * len(one.lines)) for one in code.procedures
    )
    found = line_contents(replace(code, procedures=without), world=StillWorld())
    assert sorted(text.split("\n")[line - 1] for line in found) == acting
