"""The order of what is said: findings before what takes longer, and of several changes the last."""

import io
import json
from typing import Any

import pytest

from ropsim.lsp import serve
from ropsim.lsp.testing import FrameReader, SupersededError, first_sight, nobody_calls
from support.editors import Editor

URI = "file:///nowhere/main.task"
TOKENS = "textDocument/semanticTokens/full"


def call(method: str, params: object, identity: int | None = None) -> dict[str, Any]:
    made = {"jsonrpc": "2.0", "method": method, "params": params}
    return made if identity is None else {**made, "id": identity}


def opened(text: str) -> dict[str, Any]:
    document = {"uri": URI, "languageId": "ropsim-task", "version": 1, "text": text}
    return call("textDocument/didOpen", {"textDocument": document})


def changed(text: str, version: int) -> dict[str, Any]:
    document = {"uri": URI, "version": version}
    return call("textDocument/didChange", {"textDocument": document, "contentChanges": [{"text": text}]})


def messages(*sent: dict[str, Any]) -> list[dict[str, Any]]:
    """Return in order all messages of a server for which all messages wait at once."""
    begun = (call("initialize", {"capabilities": {}}, 0), call("initialized", {}))
    bodies = [json.dumps(one).encode() for one in (*begun, *sent, call("exit", None))]
    sink = io.BytesIO()
    serve(io.BytesIO(b"".join(b"Content-Length: %d\r\n\r\n%s" % (len(one), one) for one in bodies)), sink)
    return [json.loads(one) for one in FrameReader().feed(sink.getvalue()) if isinstance(one, bytes)]


def said(*sent: dict[str, Any]) -> list[str]:
    """Return in order what a server answers and tells, in a few words."""
    told = []
    for one in messages(*sent):
        if one.get("method") == "textDocument/publishDiagnostics":
            told.append(f"findings of {one['params']['version']}: {len(one['params']['diagnostics'])}")
        elif one.get("id"):
            told.append(f"answer {one['id']}")
    return told


@pytest.mark.parametrize("method", [TOKENS, "textDocument/documentSymbol", "textDocument/foldingRange"])
def test_findings_do_not_wait_for_requests(method: str) -> None:
    asked = (call(method, {"textDocument": {"uri": URI}}, identity) for identity in (1, 2))
    told = said(opened("program p\nmov nowhere_known\n"), *asked)
    assert told == ["findings of 1: 1", "answer 1", "answer 2"]


def test_findings_of_a_text_that_has_changed_since_are_not_looked_for() -> None:
    first, second = (call(TOKENS, {"textDocument": {"uri": URI}}, identity) for identity in (1, 2))
    wrong, right = "program p\nmov nowhere_known\n", "program p\nmov home\n"
    told = said(opened(wrong), first, changed(right, 2), second)
    assert told == ["answer 1", "findings of 2: 0", "answer 2"]


def test_who_ends_the_server_waits_for_no_findings() -> None:
    assert said(opened("program p\nmov nowhere_known\n"), call("shutdown", None, 1))[0] == "answer 1"


LONG = "program p\nunits mm\n" + "mov (300, 0, 300)\nlin (300, 10, 300)\n" * 500


@pytest.mark.parametrize("method", ["textDocument/hover", TOKENS])
def test_long_work_for_a_text_gives_way_to_a_newer_one(method: str) -> None:
    place = {"line": 3, "character": 1}
    params = {"textDocument": {"uri": URI}, "position": place}
    after = LONG + "n = 1\nmov home\nprint n\n"
    asked = (call(method, params, 1), changed(after, 2), call(method, params, 2))
    first, findings, second = (one for one in messages(opened(LONG), *asked) if one.get("id") != 0)
    assert first["error"] == {"code": -32801, "message": "the text has been changed while it was looked at"}
    assert findings["params"]["version"] == 2
    assert "result" in second


def test_what_gave_way_is_worked_out_when_it_is_asked_for_again() -> None:
    editor = Editor()
    editor.open(URI, LONG)
    about = {"textDocument": {"uri": URI}, "position": {"line": 3, "character": 1}}
    editor.workshop.attention.is_called = lambda: True
    with pytest.raises(SupersededError):
        editor.ask("textDocument/hover", **about)
    editor.workshop.attention.is_called = nobody_calls
    assert "goes to (300, 10, 300) mm" in editor.ask("textDocument/hover", **about)["contents"]["value"]


def test_lines_of_a_long_text_are_told_before_it_is_checked_as_a_whole() -> None:
    asked = call("textDocument/foldingRange", {"textDocument": {"uri": URI}}, 1)
    told = said(opened(LONG + "lin (300, 10\nmov nowhere_known\n"), asked)
    assert told == ["findings of 1: 1", "findings of 1: 2", "answer 1"]
    assert said(opened(LONG), asked) == ["findings of 1: 0", "answer 1"]


def test_an_edit_of_a_long_text_that_has_been_checked_is_told_once() -> None:
    editor = Editor()
    editor.open(URI, LONG + "lin (300, 10\n")
    editor.type(URI, (2, 0), (2, 0), "mov home\n")
    assert editor.state.stale
    assert first_sight(editor.state, editor.workshop) == ()
    assert len(editor.settle()[URI]) == 1
