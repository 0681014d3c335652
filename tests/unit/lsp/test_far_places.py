"""Places that no document has: an answer comes at once, and the server goes on."""

from functools import partial
from pathlib import Path
from typing import Any

import pytest

from ropsim.lsp.testing import REQUESTS
from support.editors import Editor, place, uri_of
from support.work import calls_of, peak_of

TEXT = "program p\nunits mm, deg, s\nloc a = (400, 0, 300)\ntask Go(q: loc)\n  lin q\nendp\nGo a\nmov home\n"
FAR = 10**9
NO_PLACES: tuple[Any, ...] = (-1, 2**31, 10**30, 1.5, float("nan"), "1", None, True, [1], {})
MOST_CALLS = 20_000
"""An answer about such a text takes fewer; one that goes through lines that are not there takes 10⁹."""
MOST_MEMORY = 20_000_000

NAMES = ("main.task", "cell.toml", "kb/tasks.pl", "robots/r.toml")


@pytest.fixture(params=NAMES)
def opened(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Editor, str]:
    editor, uri = Editor(), uri_of(tmp_path / request.param)
    editor.open(uri, TEXT)
    for method in REQUESTS:  # what is made once for all answers is made
        editor.ask(method, **params(uri, place(1, 0), place(2, 0)))
    return editor, uri


def params(uri: str, start: Any, end: Any) -> dict[str, Any]:
    return {
        "textDocument": {"uri": uri},
        "position": start,
        "range": {"start": start, "end": end},
        "newName": "other",
        "previousResultId": "1",
        "query": "a",
    }


PLACES = [
    (place(0, 0), place(FAR, 0)),
    (place(0, 0), place(FAR, FAR)),
    (place(FAR, FAR), place(FAR, FAR)),
    (place(2, FAR), place(FAR, 5)),
    (place(FAR, 0), place(0, 0)),
    (place(4, 3), place(2, 1)),
]


@pytest.mark.slow
@pytest.mark.parametrize("places", PLACES, ids=str)
def test_places_behind_the_end_are_those_of_the_end(
    opened: tuple[Editor, str], places: tuple[Any, Any]
) -> None:
    editor, uri = opened
    for method in REQUESTS:
        asked = partial(editor.ask, method, **params(uri, *places))
        assert calls_of(asked) < MOST_CALLS, method
    assert peak_of(lambda: editor.ask("textDocument/codeAction", **params(uri, *places))) < MOST_MEMORY


def test_a_place_behind_the_end_is_answered_as_the_end(tmp_path: Path) -> None:
    editor, uri = Editor(), uri_of(tmp_path / "main.task")
    editor.open(uri, TEXT)
    lines = TEXT.split("\n")
    last = place(len(lines) - 1, len(lines[-1]))
    for method in REQUESTS:
        far = params(uri, place(0, 0), place(FAR, 7)) | {"position": place(FAR, 7)}
        there = params(uri, place(0, 0), last) | {"position": last}
        assert editor.ask(method, **far) == editor.ask(method, **there), method


@pytest.mark.parametrize("number", NO_PLACES, ids=repr)
def test_what_is_no_number_of_a_place_is_refused(opened: tuple[Editor, str], number: Any) -> None:
    editor, uri = opened
    for method, asked in REQUESTS.items():
        fields = asked.params.__struct_fields__
        for wrong in (place(number, 0), place(0, number)):
            found = editor.ask(method, **params(uri, wrong, wrong))
            is_refused = isinstance(found, dict) and found.get("code") == -32602
            assert is_refused is bool({"position", "range"} & {*fields}), (method, found)
    assert editor.ask("textDocument/foldingRange", textDocument={"uri": uri}) is not None


@pytest.mark.parametrize("number", NO_PLACES, ids=repr)
def test_an_edit_at_no_place_changes_nothing(opened: tuple[Editor, str], number: Any) -> None:
    editor, uri = opened
    before = editor.state.documents[uri]
    editor.type(uri, (number, 0), (FAR, FAR), "x")
    assert editor.state.documents[uri] == before
    editor.type(uri, (FAR, FAR), (FAR, FAR), "mov home\n")
    assert editor.state.documents[uri].text == TEXT + "mov home\n"
