"""`ropsim lsp` as a process, on its real streams."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from ropsim.lsp.testing import FrameReader, framed
from ropsim.workbench import new_project
from support.patience import PATIENCE


def exchange(*messages: dict[str, Any], rest: bytes = b"") -> tuple[int, list[Any], str]:
    """Send messages to a new server, end its input and return exit code, answers and standard error."""
    sent = b"".join(framed(json.dumps({"jsonrpc": "2.0", **one}).encode()) for one in messages) + rest
    done = subprocess.run(
        [sys.executable, "-m", "ropsim", "lsp"],
        input=sent,
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    answers = [json.loads(one) for one in FrameReader().feed(done.stdout) if isinstance(one, bytes)]
    return done.returncode, answers, done.stderr.decode()


START: tuple[dict[str, Any], ...] = (
    {"id": 1, "method": "initialize", "params": {"capabilities": {}}},
    {"method": "initialized", "params": {}},
)
END: tuple[dict[str, Any], ...] = ({"id": 9, "method": "shutdown"}, {"method": "exit"})


def test_a_session_from_initialize_to_exit(tmp_path: Path) -> None:
    new_project(tmp_path / "cell", "palletizing")
    program = tmp_path / "cell" / "programs" / "main.task"
    text = program.read_text("utf-8").replace("Pick infeed", "Pikc infeed")
    document = {"uri": program.as_uri(), "languageId": "task", "version": 7, "text": text}
    code, answers, errors = exchange(
        *START,
        {"method": "textDocument/didOpen", "params": {"textDocument": document}},
        {"id": 2, "method": "x/y"},
    )
    assert (code, errors) == (1, "")  # the stream ended without `shutdown` and `exit`
    by_id = {one.get("id"): one for one in answers}
    assert by_id[1]["result"]["capabilities"]["positionEncoding"] == "utf-16"
    assert by_id[2]["error"]["code"] == -32601
    (told,) = [one["params"] for one in answers if one.get("method") == "textDocument/publishDiagnostics"]
    assert told["version"] == 7
    assert [one["code"] for one in told["diagnostics"]] == ["N201"]


def test_shutdown_and_exit_end_the_process_well() -> None:
    code, answers, errors = exchange(*START, *END)
    assert (code, errors) == (0, "")
    assert answers[-1] == {"jsonrpc": "2.0", "id": 9, "result": None}


@pytest.mark.parametrize(
    "noise", [b"\xff" * 9000, b"Content-Length: x\r\n\r\n{}", b"Content-Length: 3\r\n\r\n{]}"]
)
def test_noise_ends_in_an_answer_and_no_traceback(noise: bytes) -> None:
    code, answers, errors = exchange(*START, rest=noise)
    assert (code, errors) == (1, "")
    assert answers[-1]["error"]["code"] == -32700


def asked(folder: Path, *requests: tuple[str, dict[str, Any]], text: str = "") -> list[Any]:
    """Open a program of a project in a real server and return the answers to requests about it."""
    program = folder / "programs" / "main.task"
    document = {
        "uri": program.as_uri(),
        "languageId": "task",
        "version": 1,
        "text": text or program.read_text("utf-8"),
    }
    sent = [
        {"id": number, "method": method, "params": {"textDocument": {"uri": program.as_uri()}, **params}}
        for number, (method, params) in enumerate(requests, 10)
    ]
    opening = {"method": "textDocument/didOpen", "params": {"textDocument": document}}
    code, answers, errors = exchange(*START, opening, *sent, *END)
    assert (code, errors) == (0, "")
    by_id = {one["id"]: one.get("result", one.get("error")) for one in answers if "id" in one}
    return [by_id[number] for number, _ in enumerate(requests, 10)]


def test_names_are_followed_and_changed_over_the_streams(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    at = {"position": {"line": 6, "character": 6}}
    references, marks, renamed, refused, folds, found = asked(
        folder,
        ("textDocument/references", at),
        ("textDocument/documentHighlight", at),
        ("textDocument/rename", {**at, "newName": "Fetch"}),
        ("textDocument/rename", {**at, "newName": "Place"}),
        ("textDocument/foldingRange", {}),
        ("workspace/symbol", {"query": "plc"}),
    )
    assert [one["range"]["start"]["line"] for one in references] == [6, 23]
    assert [one["kind"] for one in marks] == [3, 2]
    (edits,) = renamed["changes"].values()
    assert [one["newText"] for one in edits] == ["Fetch", "Fetch"]
    assert refused["code"] == -32803
    assert len(folds) == 3
    assert [one["name"] for one in found] == ["Place"]


def test_calls_and_places_are_explained_over_the_streams(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    hover, help_ = asked(
        folder,
        ("textDocument/hover", {"position": {"line": 8, "character": 22}}),
        ("textDocument/signatureHelp", {"position": {"line": 23, "character": 13}}),
    )
    assert "length" in hover["contents"]["value"]
    assert help_["activeParameter"] == 0


def test_colours_and_types_come_over_the_streams(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    whole = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}
    colours, hints = asked(
        folder, ("textDocument/semanticTokens/full", {}), ("textDocument/inlayHint", {"range": whole})
    )
    assert len(colours["data"]) % 5 == 0
    assert len(colours["data"]) > 100
    assert [one["label"] for one in hints] == [": loc"]


def test_a_task_is_made_of_lines_over_the_streams(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    lines = {"start": {"line": 23, "character": 0}, "end": {"line": 25, "character": 0}}
    (found,) = asked(folder, ("textDocument/codeAction", {"range": lines, "context": {"diagnostics": []}}))
    (made,) = [one for one in found if one["kind"] == "refactor.extract"]
    (edits,) = made["edit"]["changes"].values()
    assert [one["newText"] for one in edits][1] == "  Task1 slot"


def test_a_request_that_is_cancelled_is_answered_as_such(tmp_path: Path) -> None:
    document = {"uri": (tmp_path / "x.task").as_uri(), "text": "mov home\n" * 3000, "version": 1}
    about = {"textDocument": {"uri": document["uri"]}}
    _, answers, errors = exchange(
        *START,
        {"method": "textDocument/didOpen", "params": {"textDocument": document}},
        {"id": 2, "method": "textDocument/diagnostic", "params": about},
        {"id": 3, "method": "textDocument/documentSymbol", "params": about},
        {"method": "$/cancelRequest", "params": {"id": 3}},
        *END,
    )
    assert errors == ""
    by_id = {one["id"]: one for one in answers if "id" in one}
    assert by_id[2]["result"]["kind"] == "full"
    assert by_id[3]["error"]["code"] == -32800


def test_an_editor_that_shows_results_of_lines_is_told_of_them_behind_the_findings(tmp_path: Path) -> None:
    folder = new_project(tmp_path / "cell", "first_cell")
    shows = {"capabilities": {"experimental": {"ropsimLineStates": True}}}
    program = folder / "programs" / "main.task"
    text = program.read_text("utf-8")
    document = {"uri": program.as_uri(), "languageId": "task", "version": 4, "text": text}
    _, answers, errors = exchange(
        {"id": 1, "method": "initialize", "params": shows},
        START[1],
        {"method": "textDocument/didOpen", "params": {"textDocument": document}},
    )
    assert errors == ""
    findings, lines = answers[-2:]
    assert findings["method"] == "textDocument/publishDiagnostics"
    assert (lines["method"], lines["params"]["version"]) == ("ropsim/lineStates", 4)
    assert {one["state"] for one in lines["params"]["lines"]} == {"none"}
