"""The order of what is said: findings before what takes longer, and of several changes the last."""

import io
import json
from typing import Any

import pytest

from ropsim.lsp.transport import serve

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


def said(*messages: dict[str, Any]) -> list[str]:
    """Return in order what a server answers and tells when all messages wait for it at once."""
    begun = (call("initialize", {"capabilities": {}}, 0), call("initialized", {}))
    bodies = [json.dumps(one).encode() for one in (*begun, *messages, call("exit", None))]
    sink = io.BytesIO()
    serve(io.BytesIO(b"".join(b"Content-Length: %d\r\n\r\n%s" % (len(one), one) for one in bodies)), sink)
    told, rest = [], sink.getvalue()
    while rest:
        head, _, rest = rest.partition(b"\r\n\r\n")
        length = int(head.split(b"Content-Length:")[1].split()[0])
        one, rest = json.loads(rest[:length]), rest[length:]
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
