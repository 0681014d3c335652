"""Edit, simulate, look at the run, again and again; and what the processes of the studio hold meanwhile."""

import contextlib
import json
from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from support.patience import PATIENCE
from support.studio_client import Page, get, opened, page_of, secret
from support.studio_family import group, language_servers
from support.studio_process import Studio

MAIN = "programs/main.task"
_INITIALIZE = {"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": {"capabilities": {}}}
_URI = "file:///programs/main.task"


@dataclass(frozen=True, slots=True)
class Holding:
    """What one process holds: memory [bytes], open files and sockets."""

    memory: int
    descriptors: int


def holdings(studio: Studio) -> dict[int, Holding]:
    """Return what each process of a studio holds, by its number."""
    everyone = {*group(studio.process.pid), *language_servers(studio.process.pid)}
    found: dict[int, Holding] = {}
    for number in sorted(everyone):
        with contextlib.suppress(OSError):  # it has just ended
            found[number] = _holding(Path(f"/proc/{number}"))
    return found


def _holding(place: Path) -> Holding:
    lines = (place / "status").read_text("utf-8").splitlines()
    resident = next((line for line in lines if line.startswith("VmRSS")), "")
    if not resident:
        raise ProcessLookupError(place)  # it holds none any more
    return Holding(int(resident.split()[1]) * 1024, len(list((place / "fd").iterdir())))


def program(cycle: int) -> str:
    """Return a short program, another one each time."""
    return f"program main\nunits mm, deg, s\nwait {1 + cycle / 100}\nmov pick_up above {60 + cycle % 9} mm\n"


def cycles(studio: Studio, count: int) -> Generator[dict[int, Holding]]:
    """Do cycles and return what the processes hold after each.

    A cycle is an edit in the page and in the language server, its run, and fetching the run; every tenth is a
    live run as well, every fifth a save.
    """
    headers = secret(studio)
    with page_of(studio) as page, opened(studio, "/ws/lsp") as language:
        language.send(json.dumps(_INITIALIZE))
        language.recv(timeout=PATIENCE)
        document = {"uri": _URI, "languageId": "task", "version": 0, "text": program(0)}
        _tell(language, "textDocument/didOpen", {"textDocument": document})
        page.hear("run", state="done")
        for cycle in range(1, count + 1):
            text = program(cycle)
            page.say(type="edit", document=MAIN, text=text, version=cycle)
            place, changes = {"uri": _URI, "version": cycle}, [{"text": text}]
            _tell(language, "textDocument/didChange", {"textDocument": place, "contentChanges": changes})
            language.recv(timeout=PATIENCE)
            done = page.hear("run", state="done")
            assert done["simulated"] == done["id"], "the run is an earlier one"
            _fetch(studio, headers, done)
            if cycle % 5 == 0:
                page.say(type="save", document=MAIN, overwrite=False)
            if cycle % 10 == 0:
                _live(page)
            yield holdings(studio)


def _fetch(studio: Studio, headers: dict[str, str], done: dict[str, Any]) -> None:
    status, content = get(studio, f"/run/{done['id']}.pack", headers)
    assert (status, content[:2]) == (200, b"\x1f\x8b")


def _live(page: Page) -> None:
    page.start_live(1.0)
    page.say(type="live_control", action="stop")
    page.hear("live", state="over")


def _tell(language: Any, method: str, params: object) -> None:
    language.send(json.dumps({"jsonrpc": "2.0", "method": method, "params": params}))


def growth(before: dict[int, Holding], after: dict[int, Holding]) -> float:
    """Return the greatest growth of a process's memory, 0.1 for a tenth."""
    return max(after[number].memory / before[number].memory - 1.0 for number in before)
