"""An editor for tests of the language server: it opens, types and asks, without a process."""

from pathlib import Path
from typing import Any

from ropsim.lsp import State, Workshop, answer, settle
from ropsim.lsp.testing import Call


class Editor:
    """One connection; positions are given by a mark `|` in the text where that is shorter."""

    def __init__(self, **said: Any) -> None:
        self.state = State()
        self.workshop = Workshop()
        self.capabilities = self.ask("initialize", **said)["capabilities"]
        self.tell("initialized")

    def ask(self, method: str, **params: Any) -> Any:
        self.state, said = answer(self.state, Call(method, params, 1, is_request=True), self.workshop)
        (reply,) = said
        return reply["result"] if "result" in reply else reply["error"]

    def tell(self, method: str, **params: Any) -> None:
        self.state, said = answer(self.state, Call(method, params), self.workshop)
        assert said == ()

    def settle(self) -> dict[str, list[dict[str, Any]]]:
        """Return the diagnostics told, by URI."""
        self.state, said = settle(self.state, self.workshop)
        told: dict[str, list[dict[str, Any]]] = {}
        for message in said:
            params: Any = message["params"]
            told[params["uri"]] = params["diagnostics"]
        return told

    def open(self, uri: str, text: str) -> list[dict[str, Any]]:
        self.tell("textDocument/didOpen", textDocument={"uri": uri, "text": text, "version": 1})
        return self.settle().get(uri, [])

    def type(self, uri: str, start: tuple[int, int], end: tuple[int, int], text: str) -> None:
        span = {"start": place(*start), "end": place(*end)}
        self.tell(
            "textDocument/didChange",
            textDocument={"uri": uri, "version": 2},
            contentChanges=[{"range": span, "text": text}],
        )

    def at_mark(self, method: str, uri: str, marked: str, **more: object) -> Any:
        """Open a text without its mark `|` and ask about the place of the mark."""
        before, _, after = marked.partition("|")
        self.open(uri, before + after)
        lines = before.split("\n")
        position = place(len(lines) - 1, len(lines[-1]))
        return self.ask(f"textDocument/{method}", textDocument={"uri": uri}, position=position, **more)


def place(line: int, character: int) -> dict[str, int]:
    return {"line": line, "character": character}


def uri_of(path: Path) -> str:
    return path.absolute().as_uri()


def applied(text: str, edits: list[dict[str, Any]]) -> str:
    """Return a text after the edits of an answer, which do not overlap; columns are those of ASCII lines."""
    lines = text.split("\n")
    starts = [sum(len(line) + 1 for line in lines[:number]) for number in range(len(lines))]

    def offset(at: dict[str, int]) -> int:
        return starts[at["line"]] + at["character"]

    places = [(offset(one["range"]["start"]), offset(one["range"]["end"]), one) for one in edits]
    for start, end, edit in sorted(places, key=lambda one: one[:2], reverse=True):
        text = text[:start] + edit["newText"] + text[end:]
    return text
