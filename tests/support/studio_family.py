"""The processes that a studio has started, as Linux lists them."""

import contextlib
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from support.patience import GLANCE, PATIENCE

_LANGUAGE_SERVER = "ropsim language"
needs_proc = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="processes are listed by /proc")


class Process(NamedTuple):
    """A process that runs: its name, numbers of itself, its parent and its session, its command line."""

    name: str
    pid: int
    parent: int
    session: int
    words: bytes


def group(studio: int) -> list[int]:
    """Return the processes that the studio and its children are, by the session they share."""
    return [one.pid for one in _processes() if one.session == studio]


def workers(studio: int) -> list[int]:
    """Return the workers: desk and simulator."""
    return [
        one.pid for one in _copies(studio) if one.name.startswith("ropsim") and one.name != _LANGUAGE_SERVER
    ]


def origins(studio: int) -> list[int]:
    """Return the process that the workers are copies of."""
    return [one.pid for one in _processes() if one.parent == studio and b"forkserver" in one.words]


def language_servers(studio: int) -> list[int]:
    """Return the language servers."""
    return [one.pid for one in _copies(studio) if one.name == _LANGUAGE_SERVER]


def ends(studio: int) -> bool:
    """Return whether all processes of a studio are gone soon."""
    return gone(group(studio)) and not group(studio)


def gone(pids: list[int]) -> bool:
    """Return whether processes have ended soon."""
    end = time.monotonic() + PATIENCE
    while left := {one.pid for one in _processes()} & set(pids):
        if time.monotonic() > end:
            break
        time.sleep(GLANCE)
    return not left


def _copies(studio: int) -> list[Process]:
    return [one for one in _processes() if one.session == studio != one.parent and b"forkserver" in one.words]


def _processes() -> Iterator[Process]:
    for place in Path("/proc").iterdir():
        if place.name.isdigit():
            with contextlib.suppress(OSError):  # it has just ended
                head, tail = (place / "stat").read_text("utf-8").rsplit(")", 1)
                state, parent, _, session = tail.split()[:4]
                if state != "Z":
                    words = (place / "cmdline").read_bytes()
                    yield Process(head.partition("(")[2], int(place.name), int(parent), int(session), words)
