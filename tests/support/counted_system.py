"""Calls of the operating system, counted: at the k-th of them something happens or it fails.

The seam is the functions of `os` and `io` that open, list, ask for, write, sync, rename or remove a file, in
any thread. Calls for places elsewhere, such as those of the test runner, are not counted.
"""

import contextlib
import errno
import io
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any

import pytest

CALLS = (
    "open",
    "stat",
    "lstat",
    "listdir",
    "scandir",
    "mkdir",
    "fsync",
    "fchmod",
    "chmod",
    "replace",
    "rename",
    "link",
    "unlink",
    "remove",
    "readlink",
)
"""Functions of `os` that are counted, beside the writing to what `os.fdopen` returns."""


class Counted:
    """Counts calls for places below a folder: `names` are those made, `acted` tells whether one acted."""

    def __init__(self, below: Path, turn: Callable[[int, str], bool], act: Callable[[str], None]) -> None:
        self._below = str(below)
        self._turn = turn
        self._act = act
        self.acted = False
        self.names: list[str] = []

    def count(self, name: str, place: object, is_relative: bool) -> None:
        """Note a call, and act where its turn has come."""
        is_ours = is_relative or isinstance(place, int) or str(place).startswith(self._below)
        if not is_ours:
            return
        self.names.append(name)
        if not self.acted and self._turn(len(self.names), name):
            self.acted = True
            self._act(name)


def fail(error: int) -> Callable[[str], None]:
    """Return what lets a call fail with an error number."""

    def failing(name: str) -> None:
        raise OSError(error, os.strerror(error), name)

    return failing


IO_ERROR = fail(errno.EIO)


def number(wanted: int) -> Callable[[int, str], bool]:
    """Return the turn of the call of a number, from 1."""
    return lambda number, _: number == wanted


@contextlib.contextmanager
def counted(
    below: Path, turn: Callable[[int, str], bool], act: Callable[[str], None] = IO_ERROR
) -> Iterator[Counted]:
    """Count calls for places below a folder; `act` is done once, before the first one whose turn it is.

    Args:
        below: folder.
        turn: told the number of a call, from 1, and its name.
        act: told the name; what it raises, the call raises.
    """
    counting = Counted(below, turn, act)
    with pytest.MonkeyPatch.context() as patch:
        for name in CALLS:
            patch.setattr(os, name, _counting(counting, name, getattr(os, name)))
        patch.setattr(os, "fdopen", _counting_writes(counting, os.fdopen))
        patch.setattr(io, "open", _counting(counting, "open", io.open))
        yield counting


def _counting(counting: Counted, name: str, call: Callable[..., Any]) -> Callable[..., Any]:
    def called(place: Any = ".", *arguments: Any, **options: Any) -> Any:
        is_relative = any(options.get(key) is not None for key in ("dir_fd", "src_dir_fd"))
        counting.count(name, os.fspath(place) if hasattr(place, "__fspath__") else place, is_relative)
        return call(place, *arguments, **options)

    return called


def _counting_writes(counting: Counted, fdopen: Callable[..., IO[bytes]]) -> Callable[..., Any]:
    def opened(handle: int, mode: str = "r", *arguments: Any, **options: Any) -> Any:
        stream = fdopen(handle, mode, *arguments, **options)
        return _Stream(stream, counting, handle) if "w" in mode else stream

    return opened


class _Stream:
    """A stream whose writings count; one that fails has written the first half."""

    def __init__(self, stream: IO[bytes], counting: Counted, handle: int) -> None:
        self._stream = stream
        self._counting = counting
        self._handle = handle

    def __enter__(self) -> "_Stream":
        return self

    def __exit__(self, *error: object) -> None:
        self._stream.close()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, content: bytes) -> int:
        try:
            self._counting.count("write", self._handle, is_relative=False)
        except OSError:
            self._stream.write(content[: len(content) // 2])
            raise
        return self._stream.write(content)
