"""Words told apart by meaning, and types that nobody writes."""

from pathlib import Path
from typing import Any

import pytest

from ropsim.workbench import new_project
from support.editors import Editor, place, uri_of

BARE = "file:///nowhere-at-all/x.task"
TEXT = """program p
units mm, deg
loc corner = (400, 2, 300)  # a "corner"
signal glue = output 1
task "go"(q: loc, d) -> int
  needs gripper open at start
  x = sqrt(4) + q.x / 1 mm
  lin q above d speed 20 mm/s
  set glue on
  x = round(x)
  return 1
endp
n = go(corner, 5 mm)
print "x // y", n
"""
ROOT = Path(__file__).parents[3]


def decoded(editor: Editor, data: list[int], uri: str = BARE) -> list[tuple[str, str, int]]:
    """Return the words that an answer speaks of, with type and modifiers; columns count UTF-16 units."""
    lines = editor.state.documents[uri].text.split("\n")
    line = column = 0
    found = []
    for k in range(0, len(data), 5):
        down, across, length, type_, modifiers = data[k : k + 5]
        line, column = (line + down, across) if down else (line, column + across)
        units = lines[line].encode("utf-16-le")[2 * column : 2 * (column + length)]
        found.append((units.decode("utf-16-le"), LEGEND[type_], modifiers))
    return found


LEGEND: list[str] = Editor().capabilities["semanticTokensProvider"]["legend"]["tokenTypes"]


def tokens(text: str, uri: str = BARE) -> list[tuple[str, str, int]]:
    editor = Editor()
    editor.open(uri, text)
    answer = editor.ask("textDocument/semanticTokens/full", textDocument={"uri": uri})
    return decoded(editor, answer["data"], uri)


def test_words_are_told_apart_by_what_they_mean() -> None:
    found = {word: (type_, modifiers) for word, type_, modifiers in reversed(tokens(TEXT))}
    assert found["program"] == ("keyword", 0)
    assert found["corner"] == ("enumMember", 3)  # its declaration, which keeps its value
    assert found["glue"] == ("event", 3)
    assert found["go"] == ("function", 3)
    assert found["q"] == ("parameter", 1)
    assert found["x"] == ("variable", 1)
    assert found["loc"] == ("keyword", 0)
    assert ("loc", "type", 0) in tokens(TEXT)
    assert found["sqrt"] == ("function", 0)
    assert found["20 mm/s"] == ("number", 0)
    assert found['"x // y"'] == ("string", 0)
    assert found['# a "corner"'] == ("comment", 0)
    assert ("x", "property", 0) in tokens(TEXT)
    assert ("x", "variable", 4) in tokens(TEXT)


def test_the_words_of_a_contract_have_no_colour() -> None:
    words = [word for word, _, _ in tokens(TEXT)]
    assert "needs" in words
    assert not {"gripper", "start"} & set(words)


def test_names_of_the_cell_have_the_colour_of_what_they_are(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    text = "program x\nunits mm\nmov infeed\nmov (1, 2, 3) in pallet\nmov nobody\n"
    found = tokens(text, uri_of(folder / "programs" / "x.task"))
    assert ("infeed", "enumMember", 2) in found
    assert ("pallet", "namespace", 2) in found
    assert "nobody" not in [word for word, _, _ in found]


def test_wide_characters_shift_what_stands_behind_them() -> None:
    found = tokens('print "\N{ROBOT FACE}", 7\n')
    assert [word for word, _, _ in found] == ["print", '"\N{ROBOT FACE}"', "7"]


@pytest.mark.parametrize("path", sorted(ROOT.glob("examples/*/programs/*.task")), ids=lambda p: p.parts[-3])
def test_every_word_of_an_example_has_one_place(path: Path) -> None:
    found = tokens(path.read_text("utf-8"))
    assert len(found) > 20
    assert all(word == word.strip() and word for word, _, _ in found)


def test_the_words_of_some_lines_are_those_of_the_whole_there() -> None:
    editor = Editor()
    editor.open(BARE, TEXT)
    stretch = {"start": place(6, 0), "end": place(7, 3)}
    answer = editor.ask("textDocument/semanticTokens/range", textDocument={"uri": BARE}, range=stretch)
    part = decoded(editor, answer["data"])
    whole = tokens(TEXT)
    start = whole.index(part[0])
    assert whole[start : start + len(part)] == part
    assert part[0] == ("x", "variable", 1)


@pytest.mark.parametrize(
    ("start", "end", "text"),
    [
        ((6, 2), (6, 3), "y"),
        ((2, 0), (3, 0), ""),
        ((0, 0), (0, 0), "# new\n"),
        ((13, 0), (13, 0), ""),
        ((0, 0), (14, 0), ""),
    ],
)
def test_what_has_changed_makes_the_whole_answer(
    start: tuple[int, int], end: tuple[int, int], text: str
) -> None:
    editor = Editor()
    editor.open(BARE, TEXT)
    about = {"textDocument": {"uri": BARE}}
    before = editor.ask("textDocument/semanticTokens/full", **about)
    editor.type(BARE, start, end, text)
    asked = {**about, "previousResultId": before["resultId"]}
    change = editor.ask("textDocument/semanticTokens/full/delta", **asked)
    data: list[Any] = list(before["data"])
    for one in change["edits"]:
        data[one["start"] : one["start"] + one["deleteCount"]] = one["data"]
    after = editor.ask("textDocument/semanticTokens/full", **about)
    assert data == after["data"]
    assert change["resultId"] == after["resultId"]
    sent = sum(len(one["data"]) for one in change["edits"])
    assert sent < max(len(data), 1)
    unknown = editor.ask("textDocument/semanticTokens/full/delta", **about, previousResultId="older")
    assert unknown["data"] == data


def test_types_that_nobody_writes_are_shown() -> None:
    editor = Editor()
    editor.open(BARE, TEXT)
    whole = {"start": place(0, 0), "end": place(99, 0)}
    hints = editor.ask("textDocument/inlayHint", textDocument={"uri": BARE}, range=whole)
    shown = [(one["position"]["line"] + 1, one["position"]["character"], one["label"]) for one in hints]
    assert shown == [(5, 19, ": length"), (7, 3, ": num"), (13, 1, ": int")]
    part = {"start": place(6, 0), "end": place(7, 0)}
    (one,) = editor.ask("textDocument/inlayHint", textDocument={"uri": BARE}, range=part)
    assert one["label"] == ": num"


def test_the_second_loop_of_one_name_has_a_type_of_its_own() -> None:
    text = "units mm\nfor k = 1 to 2\n  print k\nendf\nfor k = 1 mm to 2 mm step 1 mm\n  print k\nendf\n"
    editor = Editor()
    editor.open(BARE, text)
    whole = {"start": place(0, 0), "end": place(99, 0)}
    hints = editor.ask("textDocument/inlayHint", textDocument={"uri": BARE}, range=whole)
    assert [one["label"] for one in hints] == [": int", ": length"]


def test_places_on_one_long_line_are_counted_once_through(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = 0

    def counted(text: str, encoding: str) -> int:
        nonlocal seen
        seen += len(text)
        return len(text.encode("utf-16-le")) // 2

    monkeypatch.setattr("ropsim.lsp.protocol.document._units", counted)
    for count in (500, 1000):
        seen, editor, text = 0, Editor(), "mov " + "a " * count + "# é"
        editor.open(BARE, text)
        seen = 0
        editor.ask("textDocument/semanticTokens/full", textDocument={"uri": BARE})
        assert seen <= 2 * len(text)
