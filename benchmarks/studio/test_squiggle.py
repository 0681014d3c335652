"""From a keystroke in a 1,000-line program to its findings, inside the language server.

Run with `make bench`; figures go into docs/explanation/performance.md.
"""

from collections.abc import Callable
from typing import Any

import pytest
from measuring import Measure
from test_front_end import program_of

from ropsim.lsp import State, Workshop, answer, settle
from ropsim.lsp.protocol.messages import Call

URI = "file:///nowhere-at-all/large.task"
LINES = 1_000


def typist(inserted: str) -> Callable[[], int]:
    """Return what types a text into the middle of the program and returns the number of findings."""
    workshop = Workshop()
    document = {"uri": URI, "text": program_of(LINES), "version": 1}
    state, _ = answer(State(), Call("initialize", {}, 1, is_request=True), workshop)
    state, _ = answer(state, Call("textDocument/didOpen", {"textDocument": document}), workshop)
    state, _ = settle(state, workshop)

    def key() -> int:
        nonlocal state
        place = {"line": LINES // 2, "character": 2}
        change = {"range": {"start": place, "end": place}, "text": inserted}
        params = {"textDocument": {"uri": URI, "version": None}, "contentChanges": [change]}
        state, _ = answer(state, Call("textDocument/didChange", params), workshop)
        state, said = settle(state, workshop)
        told: Any = said[0]["params"]
        return len(told["diagnostics"])

    return key


@pytest.mark.parametrize(("inserted", "least"), [(" ", 0), ("x", 1)], ids=["right", "wrong"])
def test_keystroke_to_findings(benchmark: Any, inserted: str, least: int) -> None:
    measure = Measure(benchmark)
    findings, time = measure(typist(inserted), rounds=10)
    assert least <= findings <= 2 * least
    measure.figure("milliseconds", time.median * 1e3)
