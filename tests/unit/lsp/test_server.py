"""One message in, answers out."""

import re
from pathlib import Path

import pytest

from ropsim.lsp import State, Workshop, answer
from ropsim.lsp.testing import Call, ErrorCode, Fault, Phase, read_message
from ropsim.workbench import new_project, new_robot_project, open_project
from support.editors import Editor, applied, place, uri_of
from support.robot_files import TWO_JOINTS

BARE = "file:///nowhere-at-all/x.task"
WRONG = "program p\nunits mm, deg, s\ntask release(q: loc)\n  lin q\nendp\nrelase (1, 2, 3)\n"


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    return folder


def test_before_initialize_every_request_is_refused() -> None:
    state, said = answer(State(), Call("textDocument/hover", {}, 1, is_request=True), Workshop())
    assert said[0]["error"] == {"code": ErrorCode.NOT_INITIALIZED, "message": "`initialize` comes first"}
    assert state.phase is Phase.NEW


def test_the_exit_code_tells_whether_shutdown_came_before() -> None:
    editor = Editor()
    assert answer(editor.state, Call("exit", None), editor.workshop)[0].exit_code == 1
    editor.ask("shutdown")
    assert answer(editor.state, Call("exit", None), editor.workshop)[0].exit_code == 0


def test_an_unknown_request_is_answered_and_an_unknown_notification_is_not() -> None:
    editor = Editor()
    assert editor.ask("textDocument/moniker")["code"] == ErrorCode.METHOD_NOT_FOUND
    editor.tell("$/setTrace", value="off")


@pytest.mark.parametrize("params", [{}, {"textDocument": 3}, {"textDocument": {"uri": "x"}, "position": {}}])
def test_wrong_parameters_are_said(params: dict[str, object]) -> None:
    assert Editor().ask("textDocument/hover", **params)["code"] == ErrorCode.INVALID_PARAMS


def test_negative_positions_are_wrong_parameters() -> None:
    position = {"line": -1, "character": 0}
    error = Editor().ask("textDocument/hover", textDocument={"uri": BARE}, position=position)
    assert error["code"] == ErrorCode.INVALID_PARAMS


@pytest.mark.parametrize("body", [b"", b"{", b"[1]", b'{"id":true,"method":"x"}', b'{"method":3}', b"\xff"])
def test_bytes_that_are_no_message_are_faults(body: bytes) -> None:
    assert isinstance(read_message(body), Fault)


def test_the_answers_of_an_editor_are_left_alone() -> None:
    assert read_message(b'{"jsonrpc":"2.0","id":4,"result":null}') is None


def test_a_finding_has_the_code_the_message_and_the_hint_of_check() -> None:
    (found,) = Editor().open(BARE, WRONG)
    assert found["code"] == "N201"
    assert found["message"] == "Task not defined: `relase`\ndid you mean `release`?"
    assert found["range"] == {"start": place(5, 0), "end": place(5, 6)}
    assert found["severity"] == 1


def test_the_findings_of_a_project_are_those_of_check(project: Path) -> None:
    program = project / "programs" / "main.task"
    program.write_text(program.read_text("utf-8").replace("infeed", "infed").replace("150 mm/s", "9 s"))
    found = Editor().open(uri_of(program), program.read_text("utf-8"))
    checked = open_project(project).compile().diagnostics
    assert [(one["code"], one["range"]["start"]["line"] + 1) for one in found] == [
        (one.code, one.span.line if one.span else 0) for one in checked
    ]
    assert len(found) >= 3


def test_a_near_name_is_offered_as_a_quick_fix_that_mends_the_text() -> None:
    editor = Editor()
    editor.open(BARE, WRONG)
    span = {"start": place(5, 0), "end": place(5, 0)}
    (action,) = editor.ask("textDocument/codeAction", textDocument={"uri": BARE}, range=span)
    assert action["title"] == "replace by `release`"
    (edit,) = action["edit"]["changes"][BARE]
    start, end = edit["range"]["start"], edit["range"]["end"]
    editor.type(BARE, (start["line"], start["character"]), (end["line"], end["character"]), edit["newText"])
    assert editor.settle() == {BARE: []}


@pytest.mark.parametrize(
    ("line", "mended"), [("lin (1, 2, 3) above 3 mmm", "mm"), ("lin (1, 2, 3) in shelve", "shelf")]
)
def test_hints_of_syntax_and_names_become_fixes(line: str, mended: str) -> None:
    text = f"program p\nunits mm, deg, s\nframe shelf = (0, 0, 1)\n{line}\n"
    found = Editor().open(BARE, text)
    assert [one["data"]["fix"]["newText"] for one in found] == [mended]


def test_each_place_of_an_unknown_name_has_a_finding_with_its_own_fix() -> None:
    text = "program p\nunits mm\nloc foo = (1, 2, 3)\nlin fo\nlin foo\nlin fo above 3\n"
    editor = Editor()
    found = editor.open(BARE, text)
    assert [(one["code"], one["range"]["start"]["line"]) for one in found] == [("N202", 3), ("N202", 5)]
    assert [one["data"]["fix"]["range"]["start"]["line"] for one in found] == [3, 5]
    first, second = found
    assert ("firstLine" in first["data"], second["data"]["firstLine"]) == (False, 4)
    assert second["relatedInformation"][0]["location"]["range"] == first["range"]
    span = {"start": place(5, 0), "end": place(5, 0)}
    (action,) = editor.ask("textDocument/codeAction", textDocument={"uri": BARE}, range=span)
    edits = action["edit"]["changes"][BARE]
    assert applied(text, edits) == text.replace("lin fo above", "lin foo above")


def test_the_pointer_tells_of_a_further_place_what_is_wrong_there() -> None:
    marked = "program p\nunits mm\nloc foo = (1, 2, 3)\nlin fo\nlin f|o"
    assert "N202" in Editor().at_mark("hover", BARE, marked)["contents"]["value"]


def test_a_near_name_in_quotes_keeps_its_quotes() -> None:
    (found, *_) = Editor().open("file:///nowhere-at-all/cell.toml", '[robot]\nmodel = "puma560x"\n')
    assert found["data"]["fix"]["newText"] == '"puma560"'


def test_only_the_last_of_several_changes_is_told() -> None:
    editor = Editor()
    editor.open(BARE, "mov home\n")
    editor.type(BARE, (0, 0), (0, 3), "mvo")
    editor.type(BARE, (0, 0), (0, 3), "lin")
    (found,) = editor.settle()[BARE]
    assert found["code"] == "T301"
    assert editor.settle() == {}


def test_an_open_cell_file_counts_instead_of_the_one_on_the_disk(project: Path) -> None:
    editor = Editor()
    program, cell = project / "programs" / "main.task", project / "cell.toml"
    assert editor.open(uri_of(program), program.read_text("utf-8")) == []
    renamed = cell.read_text("utf-8").replace("[locations.infeed]", "[locations.entry]")
    editor.tell("textDocument/didOpen", textDocument={"uri": uri_of(cell), "text": renamed})
    told = editor.settle()
    assert told[uri_of(cell)] == []
    assert {one["code"] for one in told[uri_of(program)]} == {"N202"}
    editor.tell("textDocument/didClose", textDocument={"uri": uri_of(cell)})
    assert editor.settle() == {uri_of(program): [], uri_of(cell): []}


def test_a_broken_cell_file_gets_its_findings_and_leaves_names_of_programs_alone(project: Path) -> None:
    editor = Editor()
    program, cell = project / "programs" / "main.task", project / "cell.toml"
    editor.open(uri_of(program), program.read_text("utf-8") + "lin (1, 2\n")
    editor.tell("textDocument/didOpen", textDocument={"uri": uri_of(cell), "text": "[robot]\nmodel = 3\n"})
    told = editor.settle()
    assert told[uri_of(cell)][0]["severity"] == 1
    assert [one["code"][0] for one in told[uri_of(program)]] == ["L"]


def test_the_open_file_of_a_robot_gets_its_findings_and_counts_in_the_cell(tmp_path: Path) -> None:
    editor, folder = Editor(), new_robot_project(tmp_path / "cell", "scara")
    arm, cell, program = (
        folder / "robots" / "arm.toml",
        folder / "cell.toml",
        folder / "programs" / "main.task",
    )
    text = cell.read_text("utf-8").replace('"scara"', '"robots/arm.toml"')
    (missing,) = editor.open(uri_of(cell), text)
    assert missing["code"] == "X840"
    (wrong,) = editor.open(uri_of(arm), TWO_JOINTS.replace("limits", "lmits", 1))
    assert (wrong["code"], wrong["range"]["start"]) == ("X802", place(3, 13))
    assert editor.open(uri_of(program), "program p\nunits mm, deg, s\nmov joints(10, 20)\n") == []
    editor.type(uri_of(arm), (3, 13), (3, 18), "limits")
    told = editor.settle()
    assert told[uri_of(arm)] == []
    assert told[uri_of(cell)] == []
    editor.type(uri_of(program), (2, 11), (2, 17), "10, 20, 30")
    assert [one["code"] for one in editor.settle()[uri_of(program)]] == ["T335"]


def test_saved_files_are_read_again(project: Path) -> None:
    editor = Editor()
    program, cell = project / "programs" / "main.task", project / "cell.toml"
    editor.open(uri_of(program), program.read_text("utf-8"))
    cell.write_text(cell.read_text("utf-8").replace("locations.infeed", "locations.entry"), "utf-8")
    editor.tell("workspace/didChangeWatchedFiles", changes=[])
    assert [one["code"] for one in editor.settle()[uri_of(program)]] == ["N202"]


def test_an_icr_text_gets_the_findings_of_its_reader() -> None:
    (found, *_) = Editor().open("file:///nowhere-at-all/x.icr", "ICR 1.0 x\nPROC main\n  JUMP\nEND\n")
    assert re.fullmatch(r"I\d{3}", found["code"])


def test_a_change_of_a_text_that_is_not_open_is_ignored() -> None:
    editor = Editor()
    editor.type(BARE, (0, 0), (0, 0), "x")
    assert editor.settle() == {}
