"""The processes that a studio has started, as Linux lists them."""

import contextlib
import os
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from support.patience import GLANCE, PATIENCE

_LANGUAGE_SERVER = b"ropsim language"
needs_proc = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="processes are listed by /proc")


class Process(NamedTuple):
    """A process that runs: its name, numbers of itself, its parent and its session."""

    name: bytes
    pid: int
    parent: int
    session: int


def group(studio: int) -> list[int]:
    """Return the processes that the studio and its children are, by the session they share."""
    return [one.pid for one in _processes() if one.session == studio]


def folders(studio: int) -> list[Path]:
    """Return the folders in which the processes of a studio work."""
    found: list[Path] = []
    for pid in group(studio):
        with contextlib.suppress(OSError):  # it has just ended
            found.append(Path(f"/proc/{pid}/cwd").readlink())
    return found


def workers(studio: int) -> list[int]:
    """Return the workers: desk and simulator."""
    return [
        one.pid for one in _copies(studio) if one.name.startswith(b"ropsim") and one.name != _LANGUAGE_SERVER
    ]


def origins(studio: int) -> list[int]:
    """Return the process that the workers are copies of."""
    return [one.pid for one in _processes() if one.parent == studio and _is_of_the_origin(one)]


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
    return [one for one in _processes() if one.session == studio != one.parent and _is_of_the_origin(one)]


def _is_of_the_origin(one: Process) -> bool:
    """Return whether a process is the one that the children are copies of, or a copy."""
    with contextlib.suppress(OSError):  # it has just ended
        return b"forkserver" in _content(f"/proc/{one.pid}/cmdline")
    return False


def _processes() -> Iterator[Process]:
    """Yield all processes that run: a machine has hundreds, so that of each as little as can be is read."""
    for place in os.scandir("/proc"):
        if place.name.isdigit():
            with contextlib.suppress(OSError):  # it has just ended
                head, _, tail = _content(f"{place.path}/stat").rpartition(b")")
                state, parent, _, session, _ = tail.split(None, 4)
                if state != b"Z":
                    yield Process(head.partition(b"(")[2], int(place.name), int(parent), int(session))


def _content(place: str) -> bytes:
    """Return the beginning of a file of the system, which is all of a short one."""
    file = os.open(place, os.O_RDONLY)
    try:
        return os.read(file, 4096)
    finally:
        os.close(file)
