"""Calls of the operating system, counted: at the k-th of them something happens or it fails.

The seam is the functions of `os` and `io` that open, list, describe, read, write, sync, rename or remove a
file, in any thread. Calls for places elsewhere, such as those of the test runner, are not counted.
"""

import contextlib
import errno
import io
import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any

import pytest

CALLS = (
    "open",
    "stat",
    "lstat",
    "fstat",
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
    "utime",
)
"""Functions of `os` that are counted, and reading and writing of what `os.fdopen` returns."""

_READLINK = os.readlink


class Counted:
    """Counts calls for places below a folder: `names` are those made, `acted` tells whether one acted.

    `places` are paths or handles that the calls were given, one for each name.
    """

    def __init__(self, below: Path, turn: Callable[[int, str], bool], act: Callable[[str], None]) -> None:
        self._below = (str(below), os.path.realpath(below))
        self._turn = turn
        self._act = act
        self.acted = False
        self.names: list[str] = []
        self.places: list[str] = []

    def count(self, name: str, place: object, around: int | None = None) -> None:
        """Note a call, and act where its turn has come.

        Args:
            name: of the function.
            place: path or handle of a file.
            around: handle of the folder to which the path is relative; None for none.
        """
        handle = around if around is not None else place
        path = _path_of(handle) if isinstance(handle, int) else str(place)
        if path is not None and not path.startswith(self._below):
            return
        self.names.append(name)
        self.places.append(str(place))
        if not self.acted and self._turn(len(self.names), name):
            self.acted = True
            self._act(name)


def _path_of(handle: int) -> str | None:
    """Return the path of an open file; None where the system does not say it: then its calls count."""
    try:
        return _READLINK(f"/proc/self/fd/{handle}")
    except OSError:
        return None


def fail(error: int) -> Callable[[str], None]:
    """Return what lets a call fail with an error number."""

    def failing(name: str) -> None:
        raise OSError(error, os.strerror(error), name)

    return failing


IO_ERROR = fail(errno.EIO)


def remove(folder: Path) -> Callable[[str], None]:
    """Return what removes a folder with all that is in it."""
    return lambda _: shutil.rmtree(folder, ignore_errors=True)


def cut(folder: Path) -> Callable[[str], None]:
    """Return what cuts all files of a folder to half of their size, as another program may."""

    def cutting(_: str) -> None:
        for one in folder.rglob("*"):
            if one.is_file():
                os.truncate(one, one.stat().st_size // 2)

    return cutting


FAULTS: dict[str, Callable[[Path], Callable[[str], None]]] = {
    "read or write error": lambda _: IO_ERROR,
    "full disk": lambda _: fail(errno.ENOSPC),
    "no permission": lambda _: fail(errno.EACCES),
    "too many open files": lambda _: fail(errno.EMFILE),
    "folder removed": remove,
    "files cut": cut,
}
"""What may happen at a call to the files of a folder, by name."""


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
        patch.setattr(os, "fdopen", _counting_streams(counting, os.fdopen))
        patch.setattr(io, "open", _counting(counting, "open", io.open))
        yield counting


def _counting(counting: Counted, name: str, call: Callable[..., Any]) -> Callable[..., Any]:
    def called(place: Any = ".", *arguments: Any, **options: Any) -> Any:
        around = options.get("dir_fd", options.get("src_dir_fd"))
        counting.count(name, os.fspath(place) if hasattr(place, "__fspath__") else place, around)
        return call(place, *arguments, **options)

    return called


def _counting_streams(counting: Counted, fdopen: Callable[..., IO[bytes]]) -> Callable[..., Any]:
    def opened(handle: int, mode: str = "r", *arguments: Any, **options: Any) -> Any:
        stream = fdopen(handle, mode, *arguments, **options)
        return _Stream(stream, counting, handle)

    return opened


class _Stream:
    """A stream whose readings and writings count; a writing that fails has written the first half."""

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

    def read(self, size: int = -1) -> bytes:
        self._counting.count("read", self._handle)
        return self._stream.read(size)

    def write(self, content: bytes) -> int:
        try:
            self._counting.count("write", self._handle)
        except OSError:
            self._stream.write(content[: len(content) // 2])
            raise
        return self._stream.write(content)
