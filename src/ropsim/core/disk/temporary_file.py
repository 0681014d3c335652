"""Temporary files next to the files that they become, and the removal of files left by a killed process.

A process holds a lock on its temporary file until the file has its final name. The system frees the lock when
the process ends, so a file that can be locked is left over. Systems without these locks, such as Windows, and
file systems without them keep files left by a kill.
"""

import contextlib
import os
import re
import secrets
import stat
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO

from ropsim.core.disk.file_lock import LockState, lock_handle
from ropsim.core.disk.handles import stream_of

_PREFIX = ".ropsim-"
_NAME = re.compile(rf"{re.escape(_PREFIX)}[0-9a-f]{{16}}")
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_NOFOLLOW", 0)
_LEFT = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
_CHANGED_BY_HANDLE = os.chmod in os.supports_fd
_ATTEMPTS = 5
"""At a new file, each of which another process may remove before it is locked."""


def _nothing(_: IO[bytes]) -> None:
    """Leave the stream unchanged."""


@contextlib.contextmanager
def temporary_file(
    folder: Path | int,
    content: bytes,
    permissions: int | None = 0o600,
    finish: Callable[[IO[bytes]], None] = _nothing,
) -> Iterator[str]:
    """Write a file for the block to rename or to link; it is removed afterwards unless it was renamed.

    Files that killed processes have left in the folder are removed first.

    Args:
        folder: path, or handle of a folder that is open.
        content: of the file.
        permissions: of the file once it is written; until then only the user can open it. None for the
            default permissions of the system, in force from the start.
        finish: called with the written stream before it is closed.

    Yields:
        The path of the file, relative to a folder given by its handle.

    Raises:
        OSError: the file cannot be written.
    """
    remove_left_files(folder)
    handle, name = _created(folder, 0o666 if permissions is None else 0o600)
    lock = -1
    try:
        with stream_of(handle, "wb") as stream:
            lock = os.dup(handle) if sys.platform != "win32" else -1
            stream.write(content)
            stream.flush()  # a later write would take set-user-ID bits away
            if permissions is not None:
                _set_permissions(handle, name, permissions)
            finish(stream)
        yield name
    finally:
        with contextlib.suppress(OSError):
            os.unlink(name, dir_fd=_around(folder))
        if lock >= 0:
            os.close(lock)


def _set_permissions(handle: int, name: str, permissions: int) -> None:
    """Set the permissions of an open file if they differ: not every file system can change them."""
    if stat.S_IMODE(os.fstat(handle).st_mode) != permissions:
        os.chmod(handle if _CHANGED_BY_HANDLE else name, permissions)  # noqa: PTH101 - paths have no handle


def remove_left_files(folder: Path | int) -> None:
    """Remove the temporary files of the user that a killed process has left in a folder.

    Links, files of others and files that a running process holds stay; so do files that cannot be removed.

    Args:
        folder: path, or handle of a folder that is open.
    """
    names: list[str] = []
    with contextlib.suppress(OSError), os.scandir(folder) as found:
        names = [one.name for one in found if _NAME.fullmatch(one.name)]
    for name in names:
        with contextlib.suppress(OSError):
            _remove_left(folder, name)


def _remove_left(folder: Path | int, name: str) -> None:
    """Remove a file of the user that no process holds; others stay.

    Raises:
        OSError: the system does not let it be removed.
    """
    if sys.platform == "win32":
        return
    around = _around(folder)
    handle = os.open(_path(folder, name), _LEFT, dir_fd=around)
    try:
        facts = os.fstat(handle)
        is_own = stat.S_ISREG(facts.st_mode) and facts.st_uid == os.geteuid()
        if is_own and lock_handle(handle) is LockState.HELD:
            os.unlink(_path(folder, name), dir_fd=around)
    finally:
        os.close(handle)


def _created(folder: Path | int, mode: int) -> tuple[int, str]:
    """Return the handle of a new file that this process holds, and its path.

    Raises:
        OSError: the file cannot be made.
    """
    attempts = 1 if sys.platform == "win32" else _ATTEMPTS
    while True:
        name = _path(folder, f"{_PREFIX}{secrets.token_hex(8)}")
        handle = os.open(name, _NEW, mode, dir_fd=_around(folder))
        attempts -= 1
        if not attempts or _is_held(handle):
            return handle, name
        os.close(handle)  # another process has taken it for one that was left, and removes it


def _is_held(handle: int) -> bool:
    """Lock a new file and return whether it is still in its folder; True where that cannot be known."""
    state = lock_handle(handle)
    if state is not LockState.HELD:
        return state is LockState.UNSUPPORTED
    try:
        return os.fstat(handle).st_nlink > 0
    except OSError:
        return True


def _around(folder: Path | int) -> int | None:
    return folder if isinstance(folder, int) else None


def _path(folder: Path | int, name: str) -> str:
    return name if isinstance(folder, int) else str(folder / name)
