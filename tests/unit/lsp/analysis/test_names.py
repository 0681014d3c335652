"""References, highlights, renaming, symbols of a project and folding."""

import re
from pathlib import Path
from typing import Any

import pytest

from ropsim import icr, language
from ropsim.lsp.testing import ErrorCode
from ropsim.workbench import new_project
from support.editors import Editor, applied, place, uri_of

BARE = "file:///nowhere-at-all/x.task"
PROGRAM = """program p
units mm, deg, s
loc corner = (400, 2, 300)
frame table = (300, 0, 100)
pattern slots = grid 2 x 2 from (0, 0, 40) step (70, 0, 0), (0, 90, 0)
var total: int = 0
task Go(part: loc, n: int)
  x = n + 1
  repeat x
    lin part above 20
  endr
  total = total + x
endp
Go corner, n = 3
for each slot in slots
  Go(slot in table, total)
endf
print total
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    return folder


def lines(places: list[dict[str, Any]]) -> list[int]:
    return [one["range"]["start"]["line"] + 1 for one in places]


def rename(text: str, line: int, character: int, new: str, uri: str = BARE) -> Any:
    editor = Editor()
    editor.open(uri, text)
    at = place(line - 1, character)
    return editor.ask("textDocument/rename", textDocument={"uri": uri}, position=at, newName=new)


def code(text: str) -> str:
    compiled = language.compile(text)
    assert compiled.icr is not None, compiled.diagnostics
    return icr.disassemble(compiled.icr)


def test_references_are_the_uses_of_one_meaning() -> None:
    editor = Editor()
    editor.open(BARE, PROGRAM)
    asked = {"textDocument": {"uri": BARE}, "position": place(7, 7)}
    assert lines(editor.ask("textDocument/references", **asked)) == [7, 8, 14]
    without = {**asked, "context": {"includeDeclaration": False}}
    assert lines(editor.ask("textDocument/references", **without)) == [8, 14]
    nowhere = {**asked, "position": place(0, 0)}
    assert editor.ask("textDocument/references", **nowhere) == []


def test_highlights_tell_reading_from_writing() -> None:
    found = Editor().at_mark("documentHighlight", BARE, PROGRAM.replace("  total =", "  tot|al ="))
    assert [(one["range"]["start"]["line"] + 1, one["kind"]) for one in found] == [
        (6, 3), (12, 3), (12, 2), (16, 2), (18, 2),
    ]  # fmt: skip


def test_a_name_of_the_cell_is_found_in_its_file_and_in_all_programs(folder: Path) -> None:
    other = folder / "programs" / "other.task"
    other.write_text("program other\nunits mm\nmov infeed above 20\n", "utf-8")
    program = folder / "programs" / "main.task"
    cell = (folder / "cell.toml").read_text("utf-8").split("\n")
    editor = Editor()
    editor.open(uri_of(program), program.read_text("utf-8"))
    asked = {"textDocument": {"uri": uri_of(program)}, "position": place(23, 8)}
    found = {
        one["uri"]: one["range"]["start"]["line"] for one in editor.ask("textDocument/references", **asked)
    }
    assert (found[uri_of(program)], found[uri_of(other)]) == (23, 2)
    assert "infeed" in cell[found[uri_of(folder / "cell.toml")]]


def test_a_name_in_the_cell_file_is_found_in_the_programs(folder: Path) -> None:
    place_of = folder / "cell.toml"
    text = place_of.read_text("utf-8")
    number = next(k for k, line in enumerate(text.split("\n")) if line.startswith("[frames.pallet]"))
    editor = Editor()
    editor.open(uri_of(place_of), text)
    asked = {"textDocument": {"uri": uri_of(place_of)}, "position": place(number, 10)}
    found = [one["uri"] for one in editor.ask("textDocument/references", **asked)]
    assert found == [uri_of(folder / "programs" / "main.task"), uri_of(place_of)]


def test_a_frame_and_a_signal_of_one_name_are_told_apart(folder: Path) -> None:
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text("utf-8") + "\n[signals.pallet]\ninput = 1\n", "utf-8")
    text = cell.read_text("utf-8").split("\n")
    program = uri_of(folder / "programs" / "x.task")
    head = "program x\nunits mm\n"
    frame = Editor().at_mark("definition", program, head + "mov (1, 2, 3) in pal|let")
    signal = Editor().at_mark("definition", program, head + "wait until pal|let")
    assert text[frame["range"]["start"]["line"]] == "[frames.pallet]"
    assert text[signal["range"]["start"]["line"]] == "[signals.pallet]"


PLACES = [(3, 4), (4, 6), (5, 8), (6, 4), (7, 5), (7, 8), (7, 19), (8, 2), (15, 9), (16, 6), (16, 21)]


@pytest.mark.parametrize(("line", "character"), PLACES)
def test_a_name_changed_and_changed_back_gives_the_text_and_never_other_code(
    line: int, character: int
) -> None:
    (edits,) = rename(PROGRAM, line, character, "fresh")["changes"].values()
    changed = applied(PROGRAM, edits)
    first = edits[0]["range"]
    old = PROGRAM.split("\n")[first["start"]["line"]][first["start"]["character"] : first["end"]["character"]]
    assert changed != PROGRAM
    assert re.sub(r"\bfresh\b", old, code(changed)) == code(PROGRAM)
    (back,) = rename(changed, line, character, old)["changes"].values()
    assert applied(changed, back) == PROGRAM


def test_a_task_in_quotes_keeps_them() -> None:
    text = 'task "grip"\n  mov l\nendp\ncall grip (400, 0, 300)\n'
    (edits,) = rename(text, 1, 7, "take")["changes"].values()
    assert applied(text, edits) == text.replace("grip", "take")


@pytest.mark.parametrize(
    ("line", "character", "new", "reason"),
    [
        (8, 2, "2x", "`2x` is no name"),
        (8, 2, "Repeat", "`Repeat` is a word of the language"),
        (8, 2, "sqrt", "`sqrt` is a function of the language"),
        (8, 2, "n", "`n` is a parameter in line 7 already"),
        (7, 5, "corner", "`corner` is a location in line 3 already"),
        (14, 4, "each", "a line would be read in another way"),
        (4, 6, "base", "`base` is the base frame"),
        (2, 7, "z", "`mm` is no name of this text"),
        (1, 0, "z", "`program` is no name of this text"),
    ],
)
def test_a_name_that_would_change_the_meaning_is_refused(
    line: int, character: int, new: str, reason: str
) -> None:
    text = PROGRAM.replace("Go corner,", "for k = 1 to 2\n  print k\nendf\nGo corner,")
    answer = rename(text, line, character, new)
    assert answer["code"] == ErrorCode.REQUEST_FAILED
    assert reason.replace("`", '"') in answer["message"]


def test_implicit_parameters_keep_their_names(folder: Path) -> None:
    program = folder / "programs" / "main.task"
    refused = rename("task A\n  mov l above a\nendp\nA 1\n", 2, 14, "b")
    assert "implicit parameter" in refused["message"]
    clash = rename(program.read_text("utf-8"), 7, 6, "infeed", uri_of(program))
    assert clash["message"] == 'the cell has the name "infeed"'


def test_a_name_in_a_line_that_cannot_be_read_is_not_changed() -> None:
    answer = rename(PROGRAM + "lin corner above\n", 3, 5, "edge")
    assert answer["message"] == 'line 19 names "corner" and has an error: correct it first'


def test_before_renaming_the_place_and_the_name_are_told() -> None:
    answer = Editor().at_mark("prepareRename", BARE, PROGRAM.replace("  x = n", "  x = |n"))
    assert answer == {"range": {"start": place(7, 6), "end": place(7, 7)}, "placeholder": "n"}


def test_symbols_of_the_project_are_found_by_letters_in_their_order(folder: Path) -> None:
    other = folder / "programs" / "other.task"
    other.write_text("program other\nunits mm\ntask Fetch(q: loc)\n  mov q\nendp\nFetch infeed\n", "utf-8")
    program = folder / "programs" / "main.task"
    editor = Editor()
    editor.open(uri_of(program), program.read_text("utf-8"))
    found = editor.ask("workspace/symbol", query="fch")
    assert [(one["name"], one["containerName"]) for one in found] == [("Fetch", "other")]
    assert {one["name"] for one in editor.ask("workspace/symbol", query="")} >= {
        "Pick",
        "Place",
        "slots",
        "Fetch",
    }


def test_blocks_their_branches_and_comments_fold() -> None:
    text = "# one\n# two\ntask A(n: int)\n  if n = 1\n    open\n  else\n    close\n  endif\nendp\nA 1\n"
    editor = Editor()
    editor.open(BARE, text)
    found = editor.ask("textDocument/foldingRange", textDocument={"uri": BARE})
    assert [(one["startLine"], one["endLine"], one["kind"]) for one in found] == [
        (0, 1, "comment"), (2, 7, "region"), (3, 4, "region"), (5, 6, "region"),
    ]  # fmt: skip


ROOT = Path(__file__).parents[4]


def test_every_name_that_an_example_defines_can_be_changed_and_the_code_stays() -> None:
    changed = [name for path in sorted(ROOT.glob("examples/*/programs/*.task")) for name in _changed(path)]
    assert {"Pick", "Place", "slots", "slot", "clear", "grip", "x"} <= set(changed)


def _changed(path: Path) -> list[str]:
    """Give every name of a program another one, by itself, and return the names."""
    editor, text = Editor(), path.read_text("utf-8")
    editor.open(uri_of(path), text)
    document = editor.state.documents[uri_of(path)]
    around = editor.workshop.surroundings(document, editor.state.documents)
    before = language.compile(text, around.environment).icr
    assert before is not None
    meanings = editor.workshop.uses(document, editor.state.documents).meanings()
    defined = [one for one in meanings if one.definition is not None]
    for meaning in defined:
        assert meaning.definition is not None
        at = place(meaning.definition.line - 1, meaning.definition.column - 1)
        asked = {"textDocument": {"uri": document.uri}, "position": at, "newName": "zz_fresh"}
        (edits,) = editor.ask("textDocument/rename", **asked)["changes"].values()
        after = language.compile(applied(text, edits), around.environment).icr
        assert after is not None, meaning
        assert icr.disassemble(after).replace("zz_fresh", meaning.name) == icr.disassemble(before)
    return [one.name for one in defined]
