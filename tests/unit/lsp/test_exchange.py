"""Findings that the editor asks for, units of positions, requests that nobody wants any more, wrong texts."""

from pathlib import Path
from typing import Any

import pytest

from ropsim.lsp import answer, settle
from ropsim.lsp.testing import CANCEL, Call, Inbox
from ropsim.workbench import new_project
from support.editors import Editor, place, uri_of

BARE = "file:///nowhere-at-all/x.task"
WRONG = "program p\nunits mm\nlin nobody\n"
ASKS: dict[str, Any] = {"textDocument": {"diagnostic": {}}}
REFRESHES: dict[str, Any] = {"workspace": {"diagnostics": {"refreshSupport": True}}}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    return folder


def pull(editor: Editor, uri: str, **more: str) -> Any:
    return editor.ask("textDocument/diagnostic", textDocument={"uri": uri}, **more)


def test_findings_that_are_asked_for_are_those_that_are_told() -> None:
    editor = Editor()
    told = editor.open(BARE, WRONG)
    answer_ = pull(editor, BARE)
    assert answer_["kind"] == "full"
    assert answer_["items"] == told
    assert told


def test_findings_that_the_editor_has_are_not_sent_again() -> None:
    editor = Editor(capabilities={**ASKS, **REFRESHES})
    editor.open(BARE, WRONG)
    first = pull(editor, BARE)
    assert pull(editor, BARE, previousResultId=first["resultId"]) == {
        "kind": "unchanged",
        "resultId": first["resultId"],
    }
    editor.type(BARE, (2, 10), (2, 10), " # a comment")
    assert pull(editor, BARE, previousResultId=first["resultId"])["kind"] == "unchanged"
    editor.type(BARE, (0, 0), (0, 0), "# moved\n")
    after = pull(editor, BARE, previousResultId=first["resultId"])
    assert after["kind"] == "full"
    assert [one["range"]["start"]["line"] for one in after["items"]] == [3]


def test_the_cell_file_has_findings_that_can_be_asked_for(folder: Path) -> None:
    place_of = folder / "cell.toml"
    editor = Editor(capabilities={**ASKS, **REFRESHES})
    editor.open(uri_of(place_of), place_of.read_text("utf-8").replace('model = "puma560"', 'model = "puma"'))
    (found,) = pull(editor, uri_of(place_of))["items"]
    assert "puma560" in found["message"]


def test_an_editor_that_asks_and_can_be_told_to_ask_again_is_not_told() -> None:
    editor = Editor(capabilities={**ASKS, **REFRESHES})
    assert editor.open(BARE, WRONG) == []
    assert editor.settle() == {}


@pytest.mark.parametrize("said", [ASKS, REFRESHES])
def test_every_other_editor_is_told(said: dict[str, Any]) -> None:
    assert [one["code"] for one in Editor(capabilities=said).open(BARE, WRONG)] == ["N202"]


def test_an_editor_is_told_to_ask_again_when_the_cell_has_changed(folder: Path) -> None:
    editor = Editor(capabilities={**ASKS, **REFRESHES})
    cell = folder / "cell.toml"
    for name in (folder / "programs" / "main.task", cell):
        editor.tell(
            "textDocument/didOpen",
            textDocument={"uri": uri_of(name), "text": name.read_text("utf-8"), "version": 1},
        )
    editor.state, said = settle(editor.state, editor.workshop)
    assert [one["method"] for one in said] == ["workspace/diagnostic/refresh"]
    editor.type(uri_of(folder / "programs" / "main.task"), (0, 0), (0, 0), "# x\n")
    editor.state, said = settle(editor.state, editor.workshop)
    assert said == ()
    editor.type(uri_of(cell), (0, 0), (0, 0), "# x\n")
    editor.state, again = settle(editor.state, editor.workshop)
    assert [one["method"] for one in again] == ["workspace/diagnostic/refresh"]
    assert again[0]["id"] != "ropsim-0"


@pytest.mark.parametrize(
    ("offered", "chosen", "character"),
    [
        (None, "utf-16", 13),
        (["utf-8", "utf-16"], "utf-8", 16),
        (["utf-32"], "utf-32", 12),
        (["ebcdic"], "utf-16", 13),
    ],
)
def test_positions_count_in_the_units_that_the_editor_has(
    offered: list[str] | None, chosen: str, character: int
) -> None:
    general = {"general": {"positionEncodings": offered}} if offered is not None else {}
    editor = Editor(capabilities=general)
    assert editor.capabilities["positionEncoding"] == chosen
    (found,) = editor.open(BARE, 'print "\N{ROBOT FACE}ü", nobody\n')
    assert found["range"]["start"] == place(0, character)
    editor.type(BARE, (0, character), (0, character + 6), "7")
    assert editor.state.documents[BARE].text == 'print "\N{ROBOT FACE}ü", 7\n'


def ask(identity: int) -> Call:
    return Call("textDocument/hover", {}, identity, is_request=True)


def test_a_request_is_cancelled_while_it_waits_and_no_other() -> None:
    inbox = Inbox()
    for one in (ask(1), ask(2), Call(CANCEL, {"id": 2}), ask(3), Call(CANCEL, {"id": 9}), Call(CANCEL, [])):
        inbox.put(one)
    found = [inbox.next() for _ in range(6)]
    assert inbox.is_empty
    assert [(one.id, gone) for one, gone in found if isinstance(one, Call) and one.is_request] == [
        (1, False), (2, True), (3, False),
    ]  # fmt: skip


def test_a_later_request_of_the_same_name_is_another_one() -> None:
    inbox = Inbox()
    inbox.put(ask(1))
    inbox.put(Call(CANCEL, {"id": 1}))
    assert inbox.next()[1]
    inbox.next()
    inbox.put(Call(CANCEL, {"id": 1}))
    inbox.put(ask(1))
    inbox.next()
    assert inbox.next() == (ask(1), False)


def test_while_the_cell_file_is_wrong_names_are_those_of_the_last_one(folder: Path) -> None:
    program, cell = folder / "programs" / "main.task", folder / "cell.toml"
    editor = Editor()
    editor.open(uri_of(program), program.read_text("utf-8"))
    editor.open(uri_of(cell), cell.read_text("utf-8"))
    about = {"textDocument": {"uri": uri_of(program)}, "position": place(23, 8)}
    before = editor.ask("textDocument/hover", **about)
    assert "location of the cell" in before["contents"]["value"]
    editor.type(uri_of(cell), (0, 0), (0, 0), "[[[\n")
    assert editor.settle()[uri_of(cell)]
    assert editor.ask("textDocument/hover", **about) == before
    assert editor.ask("textDocument/definition", **about)["uri"] == uri_of(cell)


def test_a_text_too_wrong_to_be_compiled_still_knows_its_tasks() -> None:
    text = "program p\nunits mm\ntask Go(q: loc)\n  lin q\nendp\nGo (400, 0, 300)\n"
    editor = Editor()
    editor.open(BARE, text)
    editor.type(BARE, (6, 0), (6, 0), "lin (\n" * 500 + "Go ")
    about = {"textDocument": {"uri": BARE}, "position": place(506, 3)}
    assert editor.ask("textDocument/signatureHelp", **about)["signatures"][0]["label"] == "Go(q: loc)"


def test_what_an_editor_says_of_itself_may_be_anything() -> None:
    for said in ({"capabilities": 3}, {"capabilities": {"general": {"positionEncodings": [3, None]}}}):
        editor = Editor(**said)
        assert editor.capabilities["positionEncoding"] == "utf-16"
        assert answer(editor.state, Call("exit", None), editor.workshop)[0].exit_code == 1
