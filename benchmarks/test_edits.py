"""From an edit to its answers: a line, all findings, the code behind them, the language server, and the disk.

Run with `make bench`; figures go into docs/explanation/performance.md.
"""

import json
import random
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import pytest
from measuring import Measure
from test_front_end import flat_program_of, program_of

import ropsim
from ropsim.core import KeptFiles, kept_from_collection
from ropsim.workbench import Workspace, new_project, open_project

TEXTS: dict[str, Callable[[int], str]] = {"of tasks": program_of, "flat": flat_program_of}
KINDS = pytest.mark.parametrize("kind", TEXTS)


class Typist:
    """Edits lines at random places of a program."""

    def __init__(self, text: str) -> None:
        self.lines = text.split("\n")
        self._chance = random.Random(5)
        self._places = [k for k, line in enumerate(self.lines) if "lin (100" in line]

    def edit(self) -> tuple[int, str]:
        """Change a number in a line, and return which one and the line."""
        place = self._chance.choice(self._places)
        line = self.lines[place]
        self.lines[place] = line.replace("300", "301") if "300" in line else line.replace("301", "300")
        return place, self.lines[place]

    def insert(self) -> None:
        """Write a new line."""
        place, line = self.edit()
        self.lines.insert(place, f"{line[: len(line) - len(line.lstrip())]}open")
        self._places = [one + (one >= place) for one in self._places]

    @property
    def text(self) -> str:
        """Return the text as it is now."""
        return "\n".join(self.lines)


def share(seconds: list[float], part: float) -> float:
    """Return the time that a part of all times does not exceed, in milliseconds."""
    return sorted(seconds)[min(int(part * len(seconds)), len(seconds) - 1)] * 1e3


def seconds_of_edits(
    typist: Typist, edit: Callable[[Typist], object], cache: ropsim.language.LineCache, rounds: int
) -> tuple[list[float], list[float]]:
    """Return the processor time of all findings, and of the code behind them, after each of some edits."""
    findings, code = [], []
    for _ in range(rounds):
        edit(typist)
        text = typist.text
        with kept_from_collection():
            start = process_time()
            found = ropsim.language.compile(text, cache=cache)
            findings.append(process_time() - start)
            assert found.ok
            start = process_time()
            assert found.icr is not None
            code.append(process_time() - start)
    return findings, code


@pytest.mark.parametrize(("lines", "rounds"), [(10_000, 60), (100_000, 10)])
@KINDS
def test_findings_and_code_after_an_edit(benchmark: Any, kind: str, lines: int, rounds: int) -> None:
    measure = Measure(benchmark)
    typist, cache = Typist(TEXTS[kind](lines)), ropsim.language.LineCache()
    start = process_time()
    with kept_from_collection():
        assert ropsim.language.compile(typist.text, cache=cache).icr is not None
    anew = process_time() - start

    def edits() -> dict[str, tuple[list[float], list[float]]]:
        changed = seconds_of_edits(typist, Typist.edit, cache, rounds)
        return {"a line": changed, "a new line": seconds_of_edits(typist, Typist.insert, cache, rounds)}

    seconds, _ = measure(edits, rounds=1, warmup=0)
    for what, (findings, code) in seconds.items():
        measure.figure(f"milliseconds of {what}: findings, median", share(findings, 0.5))
        measure.figure(f"milliseconds of {what}: findings, 95 of 100", share(findings, 0.95))
        measure.figure(f"milliseconds of {what}: code, median", share(code, 0.5))
        measure.figure(f"milliseconds of {what}: code, 95 of 100", share(code, 0.95))
    findings, code = seconds["a line"]
    part = (share(findings, 0.5) + share(code, 0.5)) / 1e3 / anew
    measure.figure("part of the work that an edit costs", part, most=1 / 50)


def test_the_edited_line_by_itself(benchmark: Any) -> None:
    measure = Measure(benchmark)
    typist = Typist(program_of(10_000))
    lines = iter([f"{typist.edit()[1]}  # {k}" for k in range(3_000)])
    _, time = measure(lambda: ropsim.language.LineCache().parsed(next(lines)), rounds=1_000)
    measure.figure("milliseconds, median", time.median * 1e3, most=1.0)


class Server:
    """The language server as a process, with its streams."""

    def __init__(self, process: "subprocess.Popen[bytes]") -> None:
        assert process.stdin is not None
        assert process.stdout is not None
        self._to, self._from = process.stdin, process.stdout

    def tell(self, method: str, params: object, identity: int | None = None) -> None:
        """Send a notification, or a request where it has an identity."""
        content = {"jsonrpc": "2.0", "method": method, "params": params}
        body = json.dumps(content if identity is None else {**content, "id": identity}).encode()
        self._to.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self._to.flush()

    def said(self) -> Any:
        """Return the next message."""
        size = 0
        while (header := self._from.readline()) not in (b"\r\n", b""):
            name, _, value = header.partition(b":")
            size = int(value) if name.lower() == b"content-length" else size
        return json.loads(self._from.read(size))


@contextmanager
def serving() -> Iterator[Server]:
    """Run the language server, which has begun."""
    command = [sys.executable, "-m", "ropsim", "lsp"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        server = Server(process)
        server.tell("initialize", {"capabilities": {}}, 1)
        server.said()
        yield server
        server.tell("exit", None)


@KINDS
def test_findings_over_the_language_server(benchmark: Any, kind: str, tmp_path: Path) -> None:
    measure = Measure(benchmark)
    typist = Typist(TEXTS[kind](10_000))
    uri = (tmp_path / "large.task").as_uri()
    with serving() as server:
        server.tell("textDocument/didOpen", {"textDocument": {"uri": uri, "text": typist.text, "version": 1}})
        assert server.said()["params"]["diagnostics"] == []
        version = 1

        def round_trip() -> float:
            nonlocal version
            version += 1
            place, line = typist.edit()
            whole = {"start": {"line": place, "character": 0}, "end": {"line": place + 1, "character": 0}}
            change = {"range": whole, "text": f"{line}\n"}
            params = {"textDocument": {"uri": uri, "version": version}, "contentChanges": [change]}
            start = perf_counter()
            server.tell("textDocument/didChange", params)
            said = server.said()["params"]
            assert (said["version"], said["diagnostics"]) == (version, [])
            return perf_counter() - start

        seconds, _ = measure(lambda: [round_trip() for _ in range(60)], rounds=1, warmup=1)
    measure.figure("milliseconds, median", share(seconds, 0.5))
    measure.figure("milliseconds, 95 of 100", share(seconds, 0.95))


@KINDS
def test_opening_100k_lines_that_were_compiled_before(benchmark: Any, kind: str, tmp_path: Path) -> None:
    measure = Measure(benchmark)
    new_project(tmp_path / "p")
    (tmp_path / "p" / "programs" / "main.task").write_text(TEXTS[kind](100_000), encoding="utf-8")
    kept = KeptFiles("kept", 64_000_000, 16_000_000, lambda: tmp_path)

    def opened() -> tuple[float, float]:
        workspace = Workspace(kept)
        start = process_time()
        with kept_from_collection():
            found = open_project(tmp_path / "p", workspace).compile()
            findings = process_time() - start
            assert all(one.icr is not None for one in found.programs.values())
        seconds = process_time() - start
        assert not any(one.is_error for one in found.diagnostics)
        workspace.keep()
        return seconds, findings

    anew, _ = opened()
    (seconds, findings), _ = measure(lambda: min(opened() for _ in range(3)), rounds=1, warmup=0)
    measure.figure("seconds anew", anew)
    measure.figure("seconds from the disk, findings", findings)
    measure.figure("seconds from the disk, with code", seconds, most=anew / 10)
