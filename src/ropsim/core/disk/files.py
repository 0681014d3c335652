"""The one door to the disk: ordinary files of bounded size are read, files are replaced in one step."""

import errno
import os
import stat
from functools import partial
from pathlib import Path
from typing import IO

from ropsim.core.disk.handles import retried, stream_of
from ropsim.core.disk.temporary_file import temporary_file

MOST_BYTES = 64_000_000
"""Bytes that a file may have where its reader names no other bound."""
_WITHOUT_WAITING = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
"""Open pipes without waiting for a writer; no effect on ordinary files."""


class NoOrdinaryFileError(OSError):
    """A path names a folder, a device, a pipe or a socket."""


class LongFileError(OSError):
    """A file has more bytes than are read."""


def read_bytes(path: Path, most: int = MOST_BYTES) -> bytes:
    """Return the content of an ordinary file; refuse pipes and devices, which could block or be endless.

    Args:
        path: of the file; links are followed.
        most: bytes that it may have.

    Raises:
        OSError: the file cannot be read.
        NoOrdinaryFileError: it is a folder, a device, a pipe or a socket.
        LongFileError: it has more bytes.
    """
    return _read(path, most)[0]


def read_own_bytes(path: Path, most: int = MOST_BYTES) -> bytes:
    """Return the content of an ordinary file that only the user could have written.

    A link to the file is accepted: settings often lie elsewhere.

    Raises:
        OSError: as `read_bytes`; `PermissionError` where others may write the file.
    """
    content, facts = _read(path, most)
    if hasattr(os, "geteuid") and (facts.st_uid != os.geteuid() or facts.st_mode & 0o022):
        raise PermissionError(errno.EACCES, "others can have written it", str(path))
    return content


def _read(path: Path, most: int) -> tuple[bytes, os.stat_result]:
    """Return the content of a file and the system's facts on the same file."""
    handle = os.open(path, os.O_RDONLY | _WITHOUT_WAITING)
    with stream_of(handle, "rb") as stream:
        facts = os.fstat(handle)
        if not stat.S_ISREG(facts.st_mode):
            raise NoOrdinaryFileError(errno.EINVAL, "it is no ordinary file", str(path))
        content = stream.read(most + 1) if facts.st_size <= most else b""
        if facts.st_size > most or len(content) > most:  # some files of the system report no size
            raise LongFileError(errno.EFBIG, f"it has more than {_size(most)}", str(path))
    return content, facts


def _size(count: int) -> str:
    return f"{count / 1e6:g} MB" if count >= 1e6 else f"{count} bytes"


def replace_file(path: Path, content: bytes) -> None:
    """Write `content` to `path` in one step: a crash leaves the old file, never half a new one.

    A link stays a link, its target is replaced. A replaced file keeps its permissions; a new one has the
    default permissions of the system. A device or a pipe, such as `/dev/null`, is written to, because it
    cannot be replaced.

    Raises:
        OSError: the folder cannot be written, or the device takes no more.
    """
    place = Path(os.path.realpath(path))  # Path.resolve raises RuntimeError where links go round
    mode = _mode(place)
    if mode is not None and not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
        with place.open("wb") as stream:
            stream.write(content)
        return
    place.parent.mkdir(parents=True, exist_ok=True)
    _replace(place, content, None if mode is None else stat.S_IMODE(mode))


def _replace(place: Path, content: bytes, permissions: int | None) -> None:
    """Put a file with these permissions in the place of another one; None for the default permissions."""
    with temporary_file(place.parent, content, permissions, on_disk) as name:
        retried(partial(Path(name).replace, place))


def on_disk(stream: IO[bytes]) -> None:
    """Have the system write its buffers of a file to the disk."""
    stream.flush()
    os.fsync(stream.fileno())


def replace_private_file(path: Path, content: bytes) -> None:
    """Write `content` to `path` in one step; at no time can other users read it, nor list a new folder.

    Raises:
        OSError: the folder cannot be written.
    """
    for folder in reversed([one for one in path.parents if not one.exists()]):
        folder.mkdir(exist_ok=True, mode=0o700)
    _replace(Path(os.path.realpath(path)), content, 0o600)


def _mode(path: Path) -> int | None:
    """Return type and permissions of the entry at a path, None without one."""
    try:
        return path.stat().st_mode
    except FileNotFoundError:
        return None
