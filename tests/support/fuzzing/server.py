"""Messages to the language server: framing, JSON and what is asked."""

import json
from random import Random

import msgspec

from ropsim.lsp import State, Workshop, answer, settle
from ropsim.lsp.testing import Fault, FrameFault, FrameReader, framed, read_message
from support.fuzzing.mutation import BYTES, TEXT, changed_value, mutated
from support.fuzzing.target import Target

_URI = "file:///nowhere-at-all/x.task"
_PROGRAM = (
    "program main\nunits mm, deg\nloc a = (500, 0, 300)\nmov a\nwhile true\n  lin a \N{ROBOT FACE}\nendw\n"
)
_DOCUMENT: dict[str, object] = {"textDocument": {"uri": _URI}}
_PLACE = {**_DOCUMENT, "position": {"line": 3, "character": 5}}
_RANGE = {"start": {"line": 1, "character": 2}, "end": {"line": 2, "character": 4}}
_OPEN = {"textDocument": {"uri": _URI, "languageId": "task", "version": 1, "text": _PROGRAM}}
_CHANGE = {
    "textDocument": {"uri": _URI, "version": 2},
    "contentChanges": [{"range": _RANGE, "text": "mvo b\n"}, {"text": _PROGRAM}],
}
_OTHERS: dict[str, dict[str, object]] = {
    "references": {**_PLACE, "context": {"includeDeclaration": False}},
    "documentHighlight": _PLACE,
    "prepareRename": _PLACE,
    "rename": {**_PLACE, "newName": "b"},
    "signatureHelp": _PLACE,
    "foldingRange": _DOCUMENT,
    "semanticTokens/full": _DOCUMENT,
    "semanticTokens/full/delta": {**_DOCUMENT, "previousResultId": "0"},
    "semanticTokens/range": {**_DOCUMENT, "range": _RANGE},
    "inlayHint": {**_DOCUMENT, "range": _RANGE},
    "codeLens": _DOCUMENT,
    "formatting": {**_DOCUMENT, "options": {"tabSize": 2, "insertSpaces": True}},
    "diagnostic": {**_DOCUMENT, "previousResultId": "0"},
}
_FURTHER: list[dict[str, object]] = [
    {"jsonrpc": "2.0", "id": number, "method": f"textDocument/{kind}", "params": params}
    for number, (kind, params) in enumerate(_OTHERS.items(), 20)
] + [
    {"jsonrpc": "2.0", "id": 40, "method": "workspace/symbol", "params": {"query": "a"}},
    {"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": 40}},
]
SESSION: list[dict[str, object]] = [
    {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}},
    {"jsonrpc": "2.0", "method": "initialized", "params": {}},
    {"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": _OPEN},
    {"jsonrpc": "2.0", "method": "textDocument/didChange", "params": _CHANGE},
    {"jsonrpc": "2.0", "id": 2, "method": "textDocument/completion", "params": _PLACE},
    {"jsonrpc": "2.0", "id": "3", "method": "textDocument/hover", "params": _PLACE},
    {"jsonrpc": "2.0", "id": 4, "method": "textDocument/definition", "params": _PLACE},
    {"jsonrpc": "2.0", "id": 5, "method": "textDocument/documentSymbol", "params": _DOCUMENT},
    {
        "jsonrpc": "2.0",
        "id": 6,
        "method": "textDocument/codeAction",
        "params": {**_DOCUMENT, "range": _RANGE},
    },
    *_FURTHER,
    {"jsonrpc": "2.0", "method": "textDocument/didClose", "params": _DOCUMENT},
    {"jsonrpc": "2.0", "id": 7, "method": "shutdown"},
    {"jsonrpc": "2.0", "method": "exit"},
]
_STREAM = b"".join(framed(json.dumps(message).encode()) for message in SESSION)


def _take(content: bytes) -> str:
    """Serve a stream of bytes as the server does, but without its net for faults of its own."""
    reader, state, workshop = FrameReader(), State(), Workshop()
    found: set[str] = set()
    for start in range(0, len(content), 997):
        for body in reader.feed(content[start : start + 997]):
            call = None if isinstance(body, FrameFault) else read_message(body)
            if call is None or isinstance(call, Fault):
                continue
            state, said = answer(state, call, workshop)
            if state.stale:
                state, more = settle(state, workshop)
                said = (*said, *more)
            for message in said:
                msgspec.json.encode(message)
                found |= {"result", "error"} & message.keys()
    return "read" if found == {"result"} else "refused"


def _made(random: Random) -> bytes:
    if random.random() < 0.15:
        return mutated(random, _STREAM, (*BYTES, *TEXT))
    messages = list(SESSION[:-2]) if random.random() < 0.9 else list(SESSION)
    sent: list[object] = list(messages)
    for _ in range(random.choice((1, 1, 2, 4))):
        place = random.randrange(2, len(sent))
        sent[place] = changed_value(random, sent[place])
    if random.random() < 0.2:
        random.shuffle(sent)
    bodies = [json.dumps(message).encode() for message in sent]
    if random.random() < 0.2:
        place = random.randrange(len(bodies))
        bodies[place] = mutated(random, bodies[place], (*TEXT, *BYTES[:3]))
    return b"".join(framed(body) for body in bodies)


TARGETS = (Target("lsp", _made, _take),)
