"""A folder that only the user can have written to, held open by its descriptor.

Owner and permissions are read from the opened folder and the opened file, never from a path that is resolved
a second time: a folder that is renamed between check and use is not used. Folders above it are not checked.
Who can write to those can rename folders there, but the folder in its place must again belong to the user.

Where folders have no descriptors and no owners (Windows), the folder lies in the profile of the user, which
the system keeps from other users. Only links are refused there.
"""

import contextlib
import errno
import os
import stat
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType
from typing import NamedTuple

from ropsim.core.disk.handles import closed_on_error, retried, stream_of
from ropsim.core.disk.temporary_file import temporary_file

_HAS_OWNERS = hasattr(os, "geteuid")
_OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
_ALONE = stat.S_IRWXU
_NO_FOLDER = (errno.ELOOP, errno.EMLINK, errno.ENOTDIR)
_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0) | getattr(os, "O_NOFOLLOW", 0)
_FILE = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


class ForeignFolderError(PermissionError):
    """Others can write to a folder, or can have written it."""


class Entry(NamedTuple):
    """A file in a folder.

    Attributes:
        used: when it was written or used last [ns].
        size: in bytes.
        name: of the file.
    """

    used: int
    size: int
    name: str


class OwnFolder:
    """A folder of the user. Close it, or use it as a context manager.

    Args:
        path: of the folder, for messages and where folders have no descriptors.
        handle: its descriptor, None where there is none.
    """

    def __init__(self, path: Path, handle: int | None) -> None:
        self.path = path
        self._handle = handle

    def __enter__(self) -> "OwnFolder":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._handle is not None:
            os.close(self._handle)

    @classmethod
    def at(cls, path: Path) -> "OwnFolder":
        """Return the folder at an absolute path.

        Raises:
            ForeignFolderError: it is a link, belongs to another user, or others can write to it.
            OSError: there is none, or it cannot be opened.
        """
        return cls(path, _opened_folder(path, str(path), None))

    @classmethod
    def made_at(cls, path: Path) -> "OwnFolder":
        """Return the folder at an absolute path; missing folders of the path are made for the user alone.

        Raises:
            ForeignFolderError: as `at`; or root would make it in the folder of another user, who could not
                write to it later.
            OSError: it cannot be made.
        """
        missing = [one for one in (path, *path.parents) if not os.path.lexists(one)]
        if missing:
            _check_not_of_others(missing[-1].parent)
        for folder in reversed(missing):
            with contextlib.suppress(FileExistsError):  # made by another process meanwhile
                folder.mkdir(mode=_ALONE)
        return cls.at(path)

    def inner(self, name: str) -> "OwnFolder":
        """Return a folder in this one.

        Raises:
            ForeignFolderError: it is a link, belongs to another user, or others can write to it.
            OSError: there is none, or it cannot be opened.
        """
        return OwnFolder(self.path / name, _opened_folder(self.path / name, self._at(name), self._handle))

    def made_inner(self, name: str) -> "OwnFolder":
        """Return a folder in this one, made where it is missing; others cannot read it.

        Raises:
            ForeignFolderError: as `inner`.
            OSError: it cannot be made.
        """
        with contextlib.suppress(FileExistsError):
            os.mkdir(self._at(name), _ALONE, dir_fd=self._handle)
        made = self.inner(name)
        if made._handle is not None:
            with contextlib.suppress(OSError):
                os.fchmod(made._handle, _ALONE)
        return made

    def read(self, name: str, most: int) -> bytes:
        """Return the content of a file and note that it was used.

        Args:
            name: of the file.
            most: bytes that it may have.

        Raises:
            OSError: it cannot be read, is no ordinary file, is larger, or others can have written it.
        """
        handle = os.open(self._at(name), os.O_RDONLY | _FILE, dir_fd=self._handle)
        with stream_of(handle, "rb") as stream:
            facts = os.fstat(handle)
            if not stat.S_ISREG(facts.st_mode) or facts.st_size > most or not _is_own(facts):
                raise PermissionError(errno.EACCES, "it is not as it was written", name)
            content = stream.read(most + 1)
            with contextlib.suppress(OSError):  # on a disk that is read only
                os.utime(handle if os.utime in os.supports_fd else self.path / name)
        return content

    def replace(self, name: str, content: bytes) -> None:
        """Write a file in one step: another process sees the old one or the new one, never a part of it.

        Raises:
            OSError: it cannot be written.
        """
        folder = self.path if self._handle is None else self._handle
        around = self._handle
        with temporary_file(folder, content) as new:
            retried(lambda: os.replace(new, self._at(name), src_dir_fd=around, dst_dir_fd=around))

    def remove(self, name: str) -> None:
        """Remove a file; a missing or undeletable one is ignored."""
        with contextlib.suppress(OSError):
            os.unlink(self._at(name), dir_fd=self._handle)

    def lock_file(self, name: str) -> int:
        """Return the descriptor of a file that processes lock; it is made where it is missing.

        Raises:
            OSError: it cannot be opened.
        """
        return os.open(self._at(name), os.O_RDWR | os.O_CREAT | _FILE, 0o600, dir_fd=self._handle)

    def entries(self) -> Iterator[Entry]:
        """Yield the ordinary files of the folder."""
        with os.scandir(self.path if self._handle is None else self._handle) as found:
            for one in found:
                with contextlib.suppress(FileNotFoundError):  # another process has removed it
                    facts = one.stat(follow_symlinks=False)
                    if stat.S_ISREG(facts.st_mode):
                        yield Entry(facts.st_mtime_ns, facts.st_size, one.name)

    def _at(self, name: str) -> str:
        return name if self._handle is not None else str(self.path / name)


def _opened_folder(path: Path, name: str, around: int | None) -> int | None:
    """Return the descriptor of the user's own folder; None on systems without such descriptors."""
    if not _HAS_OWNERS:
        facts = os.lstat(path)
        if not stat.S_ISDIR(facts.st_mode) or getattr(facts, "st_reparse_tag", False):
            raise ForeignFolderError(f"`{path}` is a link, or it is not a folder")
        return None
    try:
        handle = os.open(name, _FOLDER, dir_fd=around)
    except OSError as error:
        if error.errno in _NO_FOLDER:
            raise ForeignFolderError(f"`{path}` is a link, or it is not a folder") from None
        raise
    with closed_on_error(handle):
        facts = os.fstat(handle)
    if _is_own(facts):
        return handle
    os.close(handle)
    if facts.st_uid != os.geteuid():
        raise ForeignFolderError(f"`{path}` belongs to the user with number {facts.st_uid}, not to you")
    raise ForeignFolderError(f"others can write to `{path}` (permissions {stat.S_IMODE(facts.st_mode):03o})")


def _check_not_of_others(around: Path) -> None:
    """Raise `ForeignFolderError` where root would make a folder among folders of another user."""
    if _HAS_OWNERS and os.geteuid() == 0:
        owner = around.stat().st_uid
        if owner != 0:
            raise ForeignFolderError(f"`{around}` belongs to the user with number {owner}, and you are root")


def _is_own(facts: os.stat_result) -> bool:
    """Return whether something belongs to the user, and no other user can write to it."""
    return not _HAS_OWNERS or (facts.st_uid == os.geteuid() and not facts.st_mode & _OTHERS_WRITE)
