"""Hostile editors: whatever comes, the server answers requests, keeps no broken text and never falls over."""

import io
import json
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.lsp import serve
from ropsim.lsp.testing import (
    REQUESTS,
    ContentChange,
    Document,
    ErrorCode,
    FrameReader,
    Position,
    Range,
    framed,
)
from support.characters import ANY
from support.editors import Editor, applied, place
from support.examples import examples

URI = "file:///nowhere-at-all/x.task"
METHODS = [
    "initialize", "shutdown", "textDocument/didOpen", "textDocument/didChange", "textDocument/didClose",
    "nothing/known", "$/cancelRequest", *REQUESTS,
]  # fmt: skip

json_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**40), 2**40)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(ANY, max_size=9),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(ANY, max_size=9), inner, max_size=3),
    max_leaves=8,
)
positions = st.fixed_dictionaries({"line": st.integers(0, 5), "character": st.integers(0, 20)})
params = json_values | st.fixed_dictionaries(
    {
        "textDocument": st.fixed_dictionaries(
            {"uri": st.sampled_from([URI, "", "file:", "file:///%00"]), "text": st.text(ANY, max_size=40)}
        ),
        "position": positions,
        "newName": st.sampled_from(["b", "a", "lin", "2", ""]),
        "previousResultId": st.just("x"),
        "query": st.text(ANY, max_size=3),
        "range": st.fixed_dictionaries({"start": positions, "end": positions}),
        "contentChanges": st.lists(
            st.fixed_dictionaries(
                {"text": st.text(ANY, max_size=9)},
                optional={"range": st.fixed_dictionaries({"start": positions, "end": positions})},
            ),
            max_size=3,
        ),
    }
)
messages = st.fixed_dictionaries(
    {"method": st.sampled_from(METHODS)}, optional={"id": st.integers(0, 9), "params": params}
)
pieces = st.lists(
    st.binary(max_size=60) | messages.map(lambda m: framed(json.dumps(m).encode("utf-8", "surrogatepass"))),
    max_size=12,
)


def answers(stream: bytes) -> tuple[int, list[Any]]:
    sink = io.BytesIO()
    code = serve(io.BytesIO(stream), sink)
    found = FrameReader().feed(sink.getvalue())
    assert all(isinstance(one, bytes) for one in found)
    return code, [json.loads(one) for one in found if isinstance(one, bytes)]


@settings(max_examples=examples(60))
@given(pieces)
def test_any_bytes_are_answered_and_never_by_an_internal_error(stream: list[bytes]) -> None:
    first = framed(b'{"id": 0, "method": "initialize"}')
    _, said = answers(first + b"".join(stream))
    assert "result" in said[0]
    assert [one for one in said if one.get("error", {}).get("code") == -32603] == []
    assert [one for one in said if one.get("method") == "window/logMessage"] == []


@settings(max_examples=examples(60))
@given(st.lists(messages, max_size=8))
def test_every_request_gets_one_answer(sent: list[dict[str, Any]]) -> None:
    stream = b"".join(framed(json.dumps(m).encode()) for m in sent)
    _, said = answers(stream)
    asked = [m["id"] for m in sent if "id" in m]
    assert [one["id"] for one in said if "id" in one] == asked


characters = st.sampled_from(["a", "1", "\n", "\r\n", "\r", "\N{ROBOT FACE}", "ü", "(", "#"])
texts = st.lists(characters, max_size=20).map("".join)


def position(document: Document, offset: int) -> Position:
    """Return the protocol position of an offset: line and UTF-16 units, counted apart from what is tested."""
    line = max(k for k, start in enumerate(document.starts) if start <= offset)
    return Position(line, len(document.text[document.starts[line] : offset].encode("utf-16-le")) // 2)


@settings(max_examples=examples(200))
@given(texts, st.integers(0, 20), st.integers(0, 20), texts)
def test_a_change_in_protocol_positions_is_the_change_in_characters(
    text: str, start: int, end: int, inserted: str
) -> None:
    document = Document(URI, 1, text)
    lines = range(len(document.starts))
    ends = {k for line in lines for k in (document.starts[line], document.end(line))}
    start, end = sorted((min(start, len(text)), min(end, len(text))))
    if text[start - 1 : start + 1] == "\r\n" or text[end - 1 : end + 1] == "\r\n":
        return  # no position stands between the two characters of one line end
    assert ends <= set(range(len(text) + 1))
    first, last = (position(document, offset) for offset in (start, end))
    after = document.changed([ContentChange(inserted, Range(first, last))], 2)
    assert after.text == text[:start] + inserted + text[end:]
    assert after.starts == Document(URI, 2, after.text).starts


@settings(max_examples=examples(80))
@given(st.lists(st.tuples(texts, st.integers(0, 4), st.integers(0, 9)), max_size=4))
def test_diagnostics_stand_inside_of_the_text(edits: list[tuple[str, int, int]]) -> None:
    editor = Editor()
    editor.open(URI, "program p\nlin (1, 2\n  mvo here # \N{ROBOT FACE}\n")
    for text, line, character in edits:
        editor.type(URI, (line, character), (line, character), text)
    told = editor.settle().get(URI, [])
    document = editor.state.documents[URI]
    for one in told:
        for end in (one["range"]["start"], one["range"]["end"]):
            units = len(document.line(end["line"]).encode("utf-16-le")) // 2
            assert 0 <= end["line"] < len(document.starts)
            assert 0 <= end["character"] <= units


names = st.sampled_from(["a", "b", "c", "T"])
statements = st.builds(
    str.format,
    st.sampled_from(
        [
            "{0} = {1} + 1", "for {0} = 1 to {1}", "endf", "task {0}({1}, {2})", "endp", "{0} {1}, {2}",
            "print {0}", "loc {0} = (1, 2, 3)", "lin {0} in {1}", "frame {0} = (1, 2, 3)", "repeat {0}",
            "endr", "{0} = {1}({2})", "program {0}", "lin (1, 2", "{0} {1} = {2}", "load (a, b, c), {0}",
            "set {0} on", "{0}.x = {1}",
        ]
    ),
    names, names, names,
)  # fmt: skip


@settings(max_examples=examples(150))
@given(st.lists(statements, max_size=12).map("\n".join), st.data())
def test_a_name_changed_and_changed_back_is_the_same_text(text: str, data: st.DataObject) -> None:
    editor = Editor()
    editor.open(URI, text)
    lines = text.split("\n")
    line = data.draw(st.integers(0, len(lines) - 1))
    at = {"textDocument": {"uri": URI}, "position": place(line, data.draw(st.integers(0, len(lines[line]))))}
    answer = editor.ask("textDocument/rename", **at, newName="fresh")
    if "code" in answer:
        assert answer["code"] == ErrorCode.REQUEST_FAILED
        assert answer["message"]
        return
    (edits,) = answer["changes"].values()
    changed = applied(text, edits)
    starts = [one["range"]["start"] for one in edits]
    start = min(starts, key=lambda one: (one["line"], one["character"]))
    old = lines[start["line"]][start["character"]]
    assert changed.replace("fresh", old) == text
    editor.open(URI, changed)
    back = editor.ask("textDocument/rename", textDocument={"uri": URI}, position=start, newName=old)
    if "code" in back:  # the old name is one that other places have, too
        assert "already" in back["message"]
    else:
        assert applied(changed, *back["changes"].values()) == text
