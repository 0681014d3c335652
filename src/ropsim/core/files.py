"""The one door to the disk for everything below `meshes`.

Reads whole files, replaces files so that a reader sees the old or the new content and never half
of it, and knows the user's cache folder.
"""

import os
import stat
import sys
import tempfile
from pathlib import Path


def read_bytes(path: Path) -> bytes:
    """Return the content of a file.

    Raises:
        OSError: the file cannot be read.
    """
    return path.read_bytes()


def read_own_bytes(path: Path) -> bytes:
    """Return the content of a file that nobody but the user could have written.

    Raises:
        OSError: the file cannot be read; `PermissionError` where it is a link or others may write it.
    """
    with os.fdopen(
        os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)), "rb"
    ) as stream:
        found = os.fstat(stream.fileno())
        if sys.platform != "win32" and (found.st_uid != os.geteuid() or found.st_mode & 0o022):
            raise PermissionError(f"{path} could have been written by others")
        return stream.read()


def replace_file(path: Path, content: bytes) -> None:
    """Write `content` to `path` in one step: a crash leaves the old file, never half a new one.

    A link stays a link, its target is replaced; a replaced file keeps its permissions. A device or a pipe,
    such as `/dev/null`, is written to, because it cannot be replaced.

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
    handle, name = tempfile.mkstemp(prefix=".ropsim-", dir=place.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        Path(name).chmod(0o666 & ~_umask() if mode is None else stat.S_IMODE(mode))
        Path(name).replace(place)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def replace_private_file(path: Path, content: bytes) -> None:
    """Write `content` to `path` in one step; at no time can other users read it, nor look into a new folder.

    Raises:
        OSError: the folder cannot be written.
    """
    for folder in reversed([one for one in path.parents if not one.exists()]):
        folder.mkdir(exist_ok=True, mode=0o700)
    # a replaced file keeps its permissions
    os.close(os.open(path, os.O_CREAT | os.O_WRONLY, 0o600))
    path.chmod(0o600)
    replace_file(path, content)


def cache_folder() -> Path:
    """Return the folder of generated code and other things that can be made again.

    `ROPSIM_CACHE_DIR` overrides the place that the operating system uses for caches.
    """
    override = os.environ.get("ROPSIM_CACHE_DIR")
    if override:
        return Path(override)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA", str(Path.home() / "AppData" / "Local")))
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache")))
    return base / "ropsim"


def _mode(path: Path) -> int | None:
    """Return type and permissions of what is at a path, None where nothing is."""
    try:
        return path.stat().st_mode
    except FileNotFoundError:
        return None


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
